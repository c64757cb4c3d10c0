// genirsky: skies, seas and suns as scene files, and air along camera rays, from measured and computed
// radiances.
//
//     genirsky sky -elev sky.txt -K -b 8 12 -o sky.rad
//     genirsky air -tape7 paths.tp7 -ranges 500,1000,4000 -b 8 12 -o path.air
#include <cstdio>
#include <string>

#include "common/atomic_file.h"
#include "common/error.h"
#include "ir/genirsky/product.h"
#include "ir/genirsky/request.h"

namespace infra::ir {
namespace {

int run(int argc, char** argv) {
    const auto request = read_request(argc, argv);
    if (!request) return 0;
    const Product product = make_product(*request);  // whole before a byte of it is written
    for (const std::string& warning : product.warnings)
        std::fprintf(stderr, "genirsky: warning: %s\n", message_line(warning).c_str());
    if (request->output.empty()) {
        std::fputs(product.text.c_str(), stdout);
        return 0;
    }
    AtomicFile file(request->output);
    std::fwrite(product.text.data(), 1, product.text.size(), file.stream());
    file.commit();
    return 0;
}

}  // namespace
}  // namespace infra::ir

int main(int argc, char** argv) { return infra::run_program("genirsky", infra::ir::run, argc, argv); }
