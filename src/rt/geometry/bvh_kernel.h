// The walk of one ray through a hierarchy of boxes, as bvh_kernel.cpp compiles it for several processors.
// Include it within a namespace that has Lanes, eight floats, and Quad, four (lanes_*.h).
//
// What single precision may lose. u is 2^-24, the largest relative error of an operation; R the hierarchy's
// reach: no coordinate of a shape, or of a ray once it is near the box, is larger, no difference of two more
// than twice that.
// - Boxes. The distance of a plane is (plane - origin) / direction. The rounding of the ray's origin, of the
//   difference and of products with it are like a displacement of the plane by at most 8 u R: the build moves
//   planes outward by that much. What remains is relative, less than 10 u: `outward`.
// - Triangles. Coordinates are projected along the ray onto the plane of the two axes that it is least
// parallel
//   to; there the ray is the origin. Let `error` be the most by which a projected coordinate may be wrong: 20
//   u R (5 u R for rounding the ray's origin, a difference and a sum, for each of the two coordinates that it
//   is made of; 6 u R by the slope; 4 u R by the last operation), and half a step for each of the two.
//   Then the doubled area of an edge and the ray, a difference of two products of coordinates of at most m,
//   is wrong by less than 4 m error + 2 error^2 + 4 u m^2. A triangle that has areas of both signs, both
//   larger than that, is missed.

inline unsigned triangles_near(const BvhRay& ray, const BvhLeaf& leaf, unsigned n, float limit) {
    const Quad start = (Quad::load(leaf.origin) - Quad::load(ray.origin)).permuted(ray.axis);
    const Lanes x_start = start.spread<0>(), y_start = start.spread<1>(), z_start = start.spread<2>();
    const Lanes x_shear(ray.shear[0]), y_shear(ray.shear[1]);
    const float step_size = __builtin_bit_cast(float, std::uint32_t{leaf.exponent} << 23);
    const Lanes step(step_size);
    const auto* const x_rows = leaf.rows + 3 * n * static_cast<unsigned>(ray.axis[0]);
    const auto* const y_rows = leaf.rows + 3 * n * static_cast<unsigned>(ray.axis[1]);
    const auto* const z_rows = leaf.rows + 3 * n * static_cast<unsigned>(ray.axis[2]);
    const auto along = [&](unsigned corner) {
        return Lanes::words(z_rows + corner * n).times_plus(step, z_start);
    };
    const auto x_across = [&](unsigned corner, const Lanes& z) {
        return z.times_plus(x_shear, Lanes::words(x_rows + corner * n).times_plus(step, x_start));
    };
    const auto y_across = [&](unsigned corner, const Lanes& z) {
        return z.times_plus(y_shear, Lanes::words(y_rows + corner * n).times_plus(step, y_start));
    };
    const Lanes az = along(0), bz = along(1), cz = along(2);
    const Lanes ax = x_across(0, az), bx = x_across(1, bz), cx = x_across(2, cz);
    const Lanes ay = y_across(0, az), by = y_across(1, bz), cy = y_across(2, cz);
    const Lanes bc = bx * cy - by * cx, ca = cx * ay - cy * ax, ab = ax * by - ay * bx;

    const Lanes m = max(max(max(ax.magnitude(), bx.magnitude()), max(cx.magnitude(), ay.magnitude())),
                        max(by.magnitude(), cy.magnitude()));
    const float error = ray.error + step_size;  // half a step for each of two coordinates
    constexpr float four_u = 3e-7f;             // and a little for the roundings here
    const Lanes slack =
        m.times_plus(m.times_plus(Lanes(four_u), Lanes(4.1f * error)), Lanes(2.1f * error * error));
    const unsigned one_side =
        not_above(max(max(bc, ca), ab), slack) | not_above(Lanes(0.0f) - slack, min(min(bc, ca), ab));

    const Lanes inverse(ray.inverse_along);
    const Lanes at = az * inverse, bt = bz * inverse, ct = cz * inverse;
    const unsigned in_reach = not_above(min(min(at, bt), ct), Lanes(limit + 2 * error)) &
                              not_above(Lanes(-2 * error), max(max(at, bt), ct));
    return one_side & in_reach;
}

/// Asks for the memory of a node or a leaf, and for what whoever asked knows of its triangles.
inline void prefetch(const BvhRay& ray, std::uint32_t place) {
    constexpr std::size_t line = 64;
    if (!(place & BvhLeaf::flag)) {
        const auto* const node = reinterpret_cast<const std::uint8_t*>(ray.nodes + place);
        __builtin_prefetch(node);
        __builtin_prefetch(node + line);
        return;
    }
    const std::size_t slot = BvhLeaf::slot(place), count = BvhLeaf::count(place);
    if (slot >= ray.triangle_count) return;
    const std::uint8_t* const leaf = ray.leaves + sizeof(Bvh::Item) * slot;
    for (std::size_t at = 0; at < BvhLeaf::size(count); at += line) __builtin_prefetch(leaf + at);
    const std::uint8_t* const records = ray.records + ray.record_size * slot;
    for (std::size_t at = 0; at < ray.record_size * count; at += line) __builtin_prefetch(records + at);
}

inline void walk(BvhRay& ray) {
    // Children to visit; the upper half says where the ray enters them, so that they compare by that.
    std::uint64_t stack[BvhRay::stack_size];
    int depth = 0;
    std::uint32_t place = 0;
    const Quad inverse = Quad::load(ray.inverse), start_of_ray = Quad::load(ray.origin) * inverse;
    const int near_x = ray.near_side[0], near_y = ray.near_side[1], near_z = ray.near_side[2];
    float limit = ray.limit;

    for (;;) {
        if (place & BvhLeaf::flag) {
            const std::uint32_t slot = BvhLeaf::slot(place);
            const unsigned count = BvhLeaf::count(place);
            unsigned hits = (1u << count) - 1;
            if (slot < ray.triangle_count)
                hits &= triangles_near(
                    ray, *reinterpret_cast<const BvhLeaf*>(ray.leaves + sizeof(Bvh::Item) * slot), count,
                    limit);
            if (hits) {
                if (ray.visit(ray, slot, hits)) return;
                limit = ray.limit;
            }
        } else {
            const BvhNode& node = ray.nodes[place];
            const Quad start =
                Quad::load(node.origin).times_minus(inverse, start_of_ray);  // the fourth is of no meaning
            const Quad step = Quad::powers(node.exponent) * inverse;
            const Lanes x_start = start.spread<0>(), y_start = start.spread<1>(), z_start = start.spread<2>();
            const Lanes x_step = step.spread<0>(), y_step = step.spread<1>(), z_step = step.spread<2>();
            const Lanes enter =
                max(max(Lanes::bytes(node.plane[near_x][0]).times_plus(x_step, x_start),
                        Lanes::bytes(node.plane[near_y][1]).times_plus(y_step, y_start)),
                    max(Lanes::bytes(node.plane[near_z][2]).times_plus(z_step, z_start), Lanes(0.0f)));
            const Lanes leave = min(min(Lanes::bytes(node.plane[1 - near_x][0]).times_plus(x_step, x_start),
                                        Lanes::bytes(node.plane[1 - near_y][1]).times_plus(y_step, y_start)),
                                    Lanes::bytes(node.plane[1 - near_z][2]).times_plus(z_step, z_start));
            unsigned hits = not_above(enter, min(leave, Lanes(limit))) & ((1u << node.count) - 1);
            const auto take = [&hits] {
                const int lane = __builtin_ctz(hits);
                hits &= hits - 1;
                return lane;
            };
            if (hits) {
                const int lane = take();
                if (!hits) [[likely]] {
                    place = node.child[lane];
                    continue;
                }
                prefetch(ray, node.child[lane]);
                for (unsigned others = hits; others; others &= others - 1)
                    prefetch(ray, node.child[__builtin_ctz(others)]);
                alignas(32) float distance[BvhNode::width];
                enter.store(distance);
                const auto entry = [&](int i) {
                    return std::uint64_t{__builtin_bit_cast(std::uint32_t, distance[i])} << 32 |
                           node.child[i];
                };
                std::uint64_t nearest = entry(lane);
                const int first = depth;
                do {  // the nearest goes on, the others are kept in order
                    const std::uint64_t other = entry(take());
                    const std::uint64_t farther = other < nearest ? nearest : other;
                    nearest = other < nearest ? other : nearest;
                    int i = depth++;
                    for (; i > first && stack[i - 1] < farther; --i) stack[i] = stack[i - 1];
                    stack[i] = farther;
                } while (hits);
                place = static_cast<std::uint32_t>(nearest);
                continue;
            }
        }
        do {
            if (depth == 0) return;
            --depth;
        } while (__builtin_bit_cast(float, static_cast<std::uint32_t>(stack[depth] >> 32)) > limit);
        place = static_cast<std::uint32_t>(stack[depth]);
    }
}
