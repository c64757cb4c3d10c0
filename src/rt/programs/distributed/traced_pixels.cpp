#include "rt/programs/distributed/traced_pixels.h"

#include <algorithm>

namespace infra {
namespace {

struct Run {
    std::uint32_t first, count;  // a picture has fewer pixels than these can count
};

std::vector<Run> runs_of(std::span<const std::uint64_t> numbers) {
    std::vector<Run> runs;
    for (const std::uint64_t number : numbers) {
        if (!runs.empty() && runs.back().first + runs.back().count == number)
            ++runs.back().count;
        else
            runs.push_back({static_cast<std::uint32_t>(number), 1});
    }
    return runs;
}

/// Calls use(values, count) for each piece of memory that belongs to a run of pixels.
template <class FrameType, class Use>
void for_each_value(FrameType& frame, const Run& run, const Use& use) {
    const std::size_t channels = frame.picture.channels;
    const std::size_t first = run.first, count = run.count;
    use(frame.picture.pixels.data() + first * channels, count * channels);
    if (!frame.depth.empty()) use(frame.depth.data() + first, count);
    const std::size_t bands = frame.bands();
    if (!frame.error.empty()) use(frame.error.data() + first * bands, count * bands);
}

}  // namespace

std::vector<std::uint64_t> traced_pixels(const Frame& frame) {
    std::vector<std::uint64_t> numbers;
    for (std::size_t i = 0; i < frame.traced.size(); ++i)
        if (frame.is_traced(i)) numbers.push_back(i);
    return numbers;
}

void put_pixels(MessageWriter& out, const Frame& frame, std::span<const std::uint64_t> numbers) {
    const std::vector<Run> runs = runs_of(numbers);
    out.put_all(std::span<const Run>(runs));
    std::vector<float> values;
    for (const Run& run : runs)
        for_each_value(frame, run, [&values](const float* first, std::size_t count) {
            values.insert(values.end(), first, first + count);
        });
    out.put_all(std::span<const float>(values));
}

std::vector<std::uint64_t> take_pixels(MessageReader& in, Frame& frame) {
    const std::vector<Run> runs = in.get_all<Run>();
    const std::vector<float> values = in.get_all<float>();
    std::vector<std::uint64_t> numbers;
    std::span<const float> rest(values);
    for (const Run& run : runs) {
        if (run.first >= frame.traced.size() || run.count > frame.traced.size() - run.first)
            throw Error("a message holds pixels that are not in the picture", {}, Severity::internal);
        for_each_value(frame, run, [&rest](float* target, std::size_t count) {
            if (count > rest.size())
                throw Error("a message holds pixels of another kind", {}, Severity::internal);
            std::ranges::copy(rest.first(count), target);
            rest = rest.subspan(count);
        });
        for (std::uint64_t i = 0; i < run.count; ++i) {
            frame.mark_traced(run.first + i);
            numbers.push_back(run.first + i);
        }
    }
    return numbers;
}

}  // namespace infra
