// Numbers from data files and pictures at the place where a ray hits: what the patterns, textures and
// mixtures with data share. Each is a FunctionSet, whose expressions are the coordinates in the table, and
// functions that turn the table's values into what the primitive needs.
#pragma once

#include <array>
#include <memory>

#include "common/data/data_table.h"
#include "rt/functions/functions.h"

namespace infra {

/// One value: func(value of a data file), of brightdata and mixdata.
class DataValue {
  public:
    /// String arguments from `first` on: func datafile funcfile x1 x2.. transform.
    DataValue(ModifierContext& context, std::size_t first);

    /// False after a domain error.
    bool evaluate(Tracer& tracer, const Interaction& at, double& value) const;

  private:
    std::shared_ptr<const DataTable> table_;
    FunctionSet functions_;
};

/// What the functions of three values are given.
enum class TripleArguments {
    all,         ///< all three
    all_or_own,  ///< the second and third function only their own if they take less than three (RADIANCE)
};

/// Three functions of three values, the string arguments 0 to 2 of a primitive.
class TripleFunctions {
  public:
    TripleFunctions(ModifierContext& context, FunctionSet& functions, TripleArguments arguments);
    void apply(FunctionCall& call, const double* values, double* results) const;

  private:
    std::array<bool, 3> own_only_{};
};

/// Three values, each from a data file of its own: of colordata and texdata.
class DataTriple {
  public:
    /// String arguments: func1 func2 func3 datafile1 datafile2 datafile3 funcfile x1 x2.. transform.
    DataTriple(ModifierContext& context, TripleArguments arguments);

    /// False after a domain error.
    bool evaluate(Tracer& tracer, const Interaction& at, double* triple) const;

    /// A vector from the functions' coordinates at a hit to those of the scene, without change of length.
    Vec3 to_scene(const Tracer& tracer, const Interaction& at, const Vec3& v) const {
        return functions_.to_scene(tracer, at, v);
    }

  private:
    std::array<std::shared_ptr<const DataTable>, 3> tables_;
    FunctionSet functions_;
    TripleFunctions triple_;
};

}  // namespace infra
