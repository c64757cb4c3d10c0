// Triangles in Embree, to compare with: single rays, robust mode, single-precision hits.
#pragma once

#include <embree3/rtcore.h>

#include <array>
#include <limits>
#include <span>

#include "ray_sets.h"

namespace infra::bench {

class EmbreeScene {
  public:
    explicit EmbreeScene(std::span<const std::array<Vec3, 3>> triangles) {
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_MEDIUM);
        const RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
            mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * triangles.size()));
        auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
            mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), triangles.size()));
        unsigned number = 0;
        for (const auto& triangle : triangles)
            for (const Vec3& corner : triangle) {
                *index++ = number++;
                for (int axis = 0; axis < 3; ++axis) *vertex++ = static_cast<float>(corner[axis]);
            }
        rtcCommitGeometry(mesh);
        rtcAttachGeometry(scene_, mesh);
        rtcReleaseGeometry(mesh);
        rtcCommitScene(scene_);
    }
    ~EmbreeScene() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    struct Hit {
        float distance;
        unsigned triangle;
    };
    /// Nearest hit beyond `start`; the triangle is RTC_INVALID_GEOMETRY_ID where there is none.
    Hit intersect(const TestRay& ray, float start) {
        RTCRayHit query;
        query.ray = make_ray(ray, start, std::numeric_limits<float>::infinity());
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(scene_, &context, &query);
        return {query.ray.tfar,
                query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? query.hit.geomID : query.hit.primID};
    }
    bool occluded(const TestRay& ray, float start) {
        RTCRay query = make_ray(ray, start, static_cast<float>(ray.length));
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcOccluded1(scene_, &context, &query);
        return query.tfar < 0;
    }

  private:
    static RTCRay make_ray(const TestRay& ray, float near, float far) {
        RTCRay query;
        query.org_x = static_cast<float>(ray.origin.x);
        query.org_y = static_cast<float>(ray.origin.y);
        query.org_z = static_cast<float>(ray.origin.z);
        query.dir_x = static_cast<float>(ray.direction.x);
        query.dir_y = static_cast<float>(ray.direction.y);
        query.dir_z = static_cast<float>(ray.direction.z);
        query.tnear = near;
        query.tfar = far;
        query.time = 0;
        query.mask = ~0u;
        query.id = 0;
        query.flags = 0;
        return query;
    }

    RTCDevice device_ = rtcNewDevice("threads=1");
    RTCScene scene_ = rtcNewScene(device_);
};

}  // namespace infra::bench
