#include "rt/programs/distributed/orders.h"

#include "rt/programs/distributed/traced_pixels.h"

namespace infra {

void put_results(MessageWriter& out, const std::vector<TileResult>& results, const Frame& frame) {
    out.put(results.size());
    for (const TileResult& result : results) {
        out.put(result.tile);
        out.put(result.rays);
        put_pixels(out, frame, result.traced);
    }
}

std::vector<TileResult> take_results(MessageReader& in, Frame& frame) {
    std::vector<TileResult> results(in.get<std::size_t>());
    for (TileResult& result : results) {
        result.tile = in.get<Tile>();
        result.rays = in.get<std::uint64_t>();
        result.traced = take_pixels(in, frame);
    }
    return results;
}

void put_report(MessageWriter& out, const TracerReport& report) {
    out.put(report.rays);
    for (const std::uint64_t count : {report.bad_values, report.bad_temperatures, report.function_faults})
        out.put(count);
    out.put_text(report.last_function_fault);
}

TracerReport take_report(MessageReader& in) {
    TracerReport report;
    report.rays = in.get<RayCounts>();
    for (std::uint64_t* count : {&report.bad_values, &report.bad_temperatures, &report.function_faults})
        *count = in.get<std::uint64_t>();
    report.last_function_fault = in.get_text();
    return report;
}

}  // namespace infra
