#include "bsdf/matrix_reader.h"

#include "bsdf/blocks.h"
#include "bsdf/data_numbers.h"
#include "bsdf/matrix_table.h"
#include "common/format.h"

namespace infra {
namespace {

using Basis = std::shared_ptr<const AngleBasis>;

/// The standard's where it has the name: a file's own definition of it does not count.
Basis find_basis(const WindowElement& element, const ScatteringBlock& block, const std::string& name,
                 const char* tag) {
    if (name.empty()) throw Error(block.place, std::string("no <") + tag + ">");
    if (const AngleBasis* standard = standard_angle_basis(name)) return Basis(Basis(), standard);
    for (const AngleBasis& basis : element.bases)
        if (same_name(basis.name(), name)) return std::make_shared<const AngleBasis>(basis);
    throw Error(block.place, "unknown angle basis \"" + name + "\"",
                "LBNL/Klems Full, Half or Quarter, or one that the file defines");
}

/// Values at [out * in count + in].
struct Matrix {
    Basis in, out;
    std::vector<float> values;
};

Matrix read_matrix(const WindowElement& element, const ScatteringBlock& block, bool incident_rows,
                   std::vector<std::string>& warnings) {
    Matrix matrix{find_basis(element, block, block.column_basis, "ColumnAngleBasis"),
                  find_basis(element, block, block.row_basis, "RowAngleBasis"),
                  {}};
    const auto in_count = static_cast<std::size_t>(matrix.in->patch_count());
    const auto out_count = static_cast<std::size_t>(matrix.out->patch_count());
    const std::size_t count = in_count * out_count;
    const auto shape = [&] { return formatted("%zu x %zu values are wanted", out_count, in_count); };
    if (block.data.size() < 2 * count - 1)
        throw Error(block.data_place, "the scattering data are too few", shape());
    DataNumbers numbers(block.data, block.data_place);
    matrix.values.resize(count);
    for (std::size_t n = 0; n < count; ++n) {
        if (numbers.at_end()) throw numbers.error(formatted("only %zu scattering data", n), shape());
        const std::size_t place = incident_rows ? n % out_count * in_count + n / out_count : n;
        matrix.values[place] = numbers.next_value();
    }
    if (!numbers.at_end())
        throw numbers.error("more scattering data than the angle bases have room for", shape());
    numbers.warn_of_negatives(warnings);
    return matrix;
}

}  // namespace

std::vector<std::unique_ptr<ScatterTable>> read_matrices(const WindowElement& element,
                                                         std::vector<std::string>& warnings) {
    const bool incident_rows = same_name(element.data_structure, "Rows");
    const bool serves_other_side = transmits_one_way(element);
    std::vector<std::unique_ptr<ScatterTable>> tables;
    for (const ScatterSides sides : all_sides) {
        const auto read = [&](const char* wavelength) {
            const ScatteringBlock* block = find_block(element, sides, wavelength);
            return block ? read_matrix(element, *block, incident_rows, warnings) : Matrix{};
        };
        Matrix y = read("Visible");
        if (y.values.empty()) continue;
        Matrix x = read("CIE-X"), z = read("CIE-Z");
        MatrixValues values{std::move(y.values), {}, {}};
        const auto fits = [&](const Matrix& other) {
            return other.in && other.in->patch_count() == y.in->patch_count() &&
                   other.out->patch_count() == y.out->patch_count();
        };
        if (fits(x) && fits(z)) {
            values.x = std::move(x.values);
            values.z = std::move(z.values);
        }
        tables.push_back(
            std::make_unique<MatrixTable>(sides, y.in, y.out, std::move(values), serves_other_side));
    }
    return tables;
}

}  // namespace infra
