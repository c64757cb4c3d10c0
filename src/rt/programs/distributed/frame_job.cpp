#include "rt/programs/distributed/frame_job.h"

#include "rt/programs/view_numbers.h"

namespace infra {
namespace {

View get_view(MessageReader& in) {
    const std::optional<View> view = view_of(in.get<ViewNumbers>());
    if (!view) throw Error("a message holds no view", {}, Severity::internal);
    return *view;
}

}  // namespace

Bytes packed(const FrameJob* job) {
    MessageWriter out;
    out.put(job != nullptr);
    if (!job) return out.take();
    out.put(numbers_of(job->view));
    out.put(job->previous.has_value());
    if (job->previous) out.put(numbers_of(*job->previous));
    for (const int number : {job->width, job->height, job->first_row}) out.put(number);
    out.put(job->with_depth);
    out.put(job->with_error);
    return out.take();
}

std::optional<FrameJob> unpacked_job(const Bytes& bytes) {
    MessageReader in(bytes);
    if (!in.get<bool>()) return std::nullopt;
    FrameJob job;
    job.view = get_view(in);
    if (in.get<bool>()) job.previous = get_view(in);
    for (int* number : {&job.width, &job.height, &job.first_row}) *number = in.get<int>();
    job.with_depth = in.get<bool>();
    job.with_error = in.get<bool>();
    return job;
}

}  // namespace infra
