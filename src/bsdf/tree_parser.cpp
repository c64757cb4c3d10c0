#include "bsdf/tree_parser.h"

#include <limits>

#include "common/format.h"

namespace infra {
namespace {

class Parser {
  public:
    Parser(DataNumbers& text, int rank) : text_(text), rank_(rank) {}

    TensorTree parse() {
        nodes_.emplace_back();
        parse_node(0, 0);
        if (!text_.at_end()) throw text_.error("more after the end of the tensor tree");
        return TensorTree(rank_, std::move(nodes_), std::move(values_));
    }

  private:
    void parse_node(std::size_t number, int depth) {
        if (depth > TensorTree::finest)
            throw text_.error(formatted("the tensor tree is more than %d levels deep", TensorTree::finest));
        if (!text_.take('{')) throw text_.error("missing '{' in the tensor tree");
        if (text_.sees('{')) {
            const std::size_t first = nodes_.size(), count = std::size_t(1) << rank_;
            nodes_[number].first = index_of(first);
            nodes_.resize(first + count);
            for (std::size_t child = 0; child < count; ++child) parse_node(first + child, depth + 1);
        } else {
            parse_grid(nodes_[number], depth);
        }
        if (!text_.take('}')) throw text_.error("missing '}' in the tensor tree");
    }

    void parse_grid(TensorTree::Node& node, int depth) {
        const std::size_t first = values_.size();
        while (!text_.at_end() && !text_.sees('}')) values_.push_back(text_.next_value());
        const std::size_t count = values_.size() - first;
        int log2 = 0;
        while (log2 + depth < TensorTree::finest && std::size_t(1) << (log2 + 1) * rank_ <= count) ++log2;
        if (std::size_t(1) << log2 * rank_ != count)
            throw text_.error(formatted("%zu values in a grid of the tensor tree", count),
                              rank_ == 3 ? "1, 8, 64, 512..." : "1, 16, 256, 4096...");
        node.first = index_of(first);
        node.log2_grid = log2;
    }

    std::uint32_t index_of(std::size_t n) const {
        if (n > std::numeric_limits<std::uint32_t>::max()) throw text_.error("the tensor tree is too large");
        return static_cast<std::uint32_t>(n);
    }

    DataNumbers& text_;
    int rank_;
    std::vector<TensorTree::Node> nodes_;
    std::vector<float> values_;
};

}  // namespace

TensorTree parse_tensor_tree(DataNumbers& text, int rank) { return Parser(text, rank).parse(); }

}  // namespace infra
