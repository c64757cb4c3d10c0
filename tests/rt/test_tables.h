// Three BRDF tables of different shape as files, for scenes with nrlbrdf.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "common/test_files.h"
#include "nrlbrdf/models.h"
#include "nrlbrdf/table_file.h"

namespace infra::test {

struct TableFile {
    std::string name;
    std::string path;
    std::shared_ptr<const BrdfTable> table;
    bool reciprocal;
};

/// Writes them into a folder and reads them back, as a scene does.
inline std::vector<TableFile> write_tables(const TemporaryFolder& folder) {
    // No model of anything: lopsided in phi, with zeros, and no lobe for the normal viewer.
    const BrdfFunction lopsided = [](double theta_i, double phi, double theta_r) {
        const double ripple = std::sin(phi - 1) + 0.4 * std::sin(5 * phi) + 0.2 * std::cos(3 * theta_i);
        return ripple > 0 ? 0.3 * ripple * std::sin(theta_r) : 0;
    };
    std::vector<TableFile> tables;
    const auto add = [&](const std::string& name, const BrdfFunction& f, const GridCounts& counts,
                         bool reciprocal) {
        const std::string path = folder / (name + ".brdf");
        write_table(path, tabulate(f, counts));
        tables.push_back({name, path, load_table(path).table, reciprocal});
    };
    add("gaussian", gaussian_lobe(0.2, 0.5, 0.25), {46, 72, 46}, true);
    add("phong", phong_lobe(0.3, 0.4, 8), {31, 20, 31}, true);
    add("lopsided", lopsided, {7, 31, 5}, false);
    return tables;
}

}  // namespace infra::test
