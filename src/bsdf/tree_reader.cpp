#include "bsdf/tree_reader.h"

#include "bsdf/blocks.h"
#include "bsdf/tree_parser.h"
#include "bsdf/tree_table.h"

namespace infra {
namespace {

TensorTree read_tree(const ScatteringBlock& block, int rank, std::vector<std::string>& warnings) {
    if (!same_name(block.tree_basis, "LBNL/Shirley-Chiu"))
        throw Error(block.place, "angle basis \"" + block.tree_basis + "\" of a tensor tree",
                    "<AngleBasis> must be LBNL/Shirley-Chiu");
    DataNumbers numbers(block.data, block.data_place);
    TensorTree tree = parse_tensor_tree(numbers, rank);
    numbers.warn_of_negatives(warnings);
    return tree;
}

}  // namespace

std::vector<std::unique_ptr<ScatterTable>> read_trees(const WindowElement& element,
                                                      std::vector<std::string>& warnings) {
    const int rank = same_name(element.data_structure, "TensorTree3") ? 3 : 4;
    const bool serves_other_side = transmits_one_way(element);
    std::vector<std::unique_ptr<ScatterTable>> tables;
    for (const ScatterSides sides : all_sides) {
        const ScatteringBlock* y = find_block(element, sides, "Visible");
        if (!y) continue;
        TreeValues values{read_tree(*y, rank, warnings), {}, {}};
        const ScatteringBlock* u = find_block(element, sides, "CIE-u");
        const ScatteringBlock* v = find_block(element, sides, "CIE-v");
        if (u && v) {
            values.u = read_tree(*u, rank, warnings);
            values.v = read_tree(*v, rank, warnings);
        }
        try {
            tables.push_back(std::make_unique<TreeTable>(sides, std::move(values), serves_other_side));
        } catch (const Error& error) {
            throw Error(y->place, error.message(), error.hint());
        }
    }
    return tables;
}

}  // namespace infra
