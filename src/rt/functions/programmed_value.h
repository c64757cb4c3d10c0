// The number that plasfunc and its kin compute for the direction to a light source: from a function, or from
// a data file looked up at functions of that direction.
#pragma once

#include <memory>

#include "common/data/data_table.h"
#include "rt/functions/functions.h"

namespace infra {

/// Functions of the direction to a light source get four arguments: that direction, in the coordinates of the
/// function file and unit length, and the solid angle of the source [sr]. They may take fewer.
struct SourceArguments {
    double values[4];

    SourceArguments(const FunctionCall& call, const Vec3& wi, double omega);
};

class ProgrammedValue {
  public:
    enum class Kind {
        function,  ///< string arguments: func funcfile transform
        data,      ///< func datafile funcfile x1 x2.. transform; func gets the file's value first
    };
    /// throws  Error for undefined functions, missing files, too few coordinates
    ProgrammedValue(ModifierContext& context, Kind kind);

    /// False after a domain error: RADIANCE then leaves the reflection out.
    bool evaluate(Tracer& tracer, const Interaction& at, const MaterialVariables& variables, const Vec3& wi,
                  double omega, double& value) const;

  private:
    std::shared_ptr<const DataTable> table_;  ///< nullptr: none
    FunctionSet functions_;
};

}  // namespace infra
