// Which material a face gets by its names: the mapping files of RADIANCE's converters.
//
//     default ;
//     wood (Group "thingy") (Map "pine") ;
//     brass (Face [50:175]) ;
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/mesh/face_sink.h"

namespace infra {

class MaterialRules {
  public:
    /// Reads a mapping file.
    ///   throws  Error with file and line for a missing or malformed one
    explicit MaterialRules(const std::string& path);

    /// Material of the last rule that all conditions of hold; nothing if none does, or if that is "void".
    std::optional<std::string> material(const Face& face) const;

  private:
    enum class Subject { material, map, group, object, face };
    struct Condition {
        Subject subject = Subject::material;
        std::string name;
        long long low = 0, high = 0;  ///< of a face's number
    };
    struct Rule {
        std::string material;
        std::vector<Condition> conditions;
    };
    class Parser;

    static bool holds(const Condition& condition, const Face& face);

    std::vector<Rule> rules_;
};

}  // namespace infra
