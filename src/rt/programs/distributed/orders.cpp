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

void put_faults(MessageWriter& out, const TracerFaults& faults) {
    for (const std::uint64_t count : {faults.bad_values, faults.bad_temperatures, faults.function_faults})
        out.put(count);
    out.put_text(faults.last_function_fault);
}

TracerFaults take_faults(MessageReader& in) {
    TracerFaults faults;
    for (std::uint64_t* count : {&faults.bad_values, &faults.bad_temperatures, &faults.function_faults})
        *count = in.get<std::uint64_t>();
    faults.last_function_fault = in.get_text();
    return faults;
}

}  // namespace infra
