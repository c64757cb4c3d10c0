#include "scene/rad_reader.h"

#include <cerrno>
#include <cstring>
#include <memory>

#include "scene/command_pipe.h"
#include "scene/rad_parser.h"

namespace infra {
namespace {

/// Commands within the output of commands; a file that runs `cat` on itself would go on for ever.
constexpr int deepest_nesting = 64;

constexpr std::string_view void_name = "void";
constexpr std::string_view inherit_name = "inherit";

/// Gives parsed primitives their meaning within one scene.
class Reader {
  public:
    Reader(Scene& scene, const WarningSink& warn) : scene_(scene), warn_(warn) {}

    void read_spec(const std::string& spec);
    void read(TextSource source);

  private:
    void add(const RadParser& parser, std::int32_t file);
    PrimitiveId modifier_named(std::string_view name, const RadParser& parser, const char* role) const;
    std::string hint_for_modifier(std::string_view name, const RadParser& parser) const;

    Scene& scene_;
    const WarningSink& warn_;
    int nesting_ = 0;
    // The modifier named last, until another is defined: surfaces of one stand together mostly.
    std::string latest_name_;
    PrimitiveId latest_ = void_primitive;
};

void Reader::read_spec(const std::string& spec) {
    if (spec.empty()) return read(TextSource(stdin, "standard input"));
    if (spec[0] == '!') {
        const std::string title = command_title(spec);
        if (++nesting_ > deepest_nesting)
            throw Error(Location{title},
                        "commands run one another " + std::to_string(deepest_nesting) + " levels deep",
                        "does the file run a command that reads the file itself?");
        CommandPipe pipe(spec.substr(1));
        read(TextSource(pipe.stream(), title));
        if (!pipe.close()) warn_("bad status from " + title);
        --nesting_;
        return;
    }
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(spec.c_str(), "r"), std::fclose);
    if (!file) throw Error("cannot open scene file \"" + spec + "\": " + std::strerror(errno));
    std::setvbuf(file.get(), nullptr, _IONBF, 0);  // the source of text has a buffer
    read(TextSource(file.get(), spec));
}

void Reader::read(TextSource source) {
    const std::string name = source.name();
    const std::int32_t file = scene_.add_file(name);
    const PrimitiveId before = scene_.size();
    RadParser parser(std::move(source));
    for (auto item = parser.next(); item != RadParser::Item::end; item = parser.next()) {
        if (item == RadParser::Item::command) read_spec(parser.text());
        if (item == RadParser::Item::primitive) add(parser, file);
    }
    if (scene_.size() == before) warn_(name + ": empty file");
}

/// What else a name that is no modifier may be: a slip, a surface, or an argument left over by a wrong count.
std::string Reader::hint_for_modifier(std::string_view name, const RadParser& parser) const {
    const std::string near = nearest_name(name, scene_.modifier_names());
    if (!near.empty()) {
        const Location where = scene_.location(scene_.find_modifier(near));
        std::string hint = "did you mean \"" + near + "\"";
        if (!where.file.empty()) hint += ", " + where.file + ":" + std::to_string(where.line);
        return hint + "?";
    }
    for (PrimitiveId id = scene_.size(); id-- > 0;)
        if (scene_.name(id) == name)
            return "\"" + std::string(name) + "\" is a " + std::string(scene_.type_info(id).name) +
                   ", which cannot modify";
    const bool numeric = name.find_first_not_of("0123456789+-.eE") == std::string_view::npos;
    if (numeric && !parser.previous().empty())
        return "has " + parser.previous() + " before it the right number of arguments?";
    return "";
}

PrimitiveId Reader::modifier_named(std::string_view name, const RadParser& parser, const char* role) const {
    const PrimitiveId id = scene_.find_modifier(name);
    if (id != void_primitive) return id;
    throw Error(parser.location(),
                std::string("undefined ") + role + " \"" + std::string(name) + "\" for " +
                    parser.primitive().description(),
                hint_for_modifier(name, parser));
}

void Reader::add(const RadParser& parser, std::int32_t file) {
    const ParsedPrimitive& p = parser.primitive();
    const bool inherits = p.modifier == inherit_name;
    PrimitiveId modifier = void_primitive;
    if (latest_ != void_primitive && p.modifier == latest_name_) {
        modifier = latest_;
    } else if (!inherits && p.modifier != void_name) {
        modifier = modifier_named(p.modifier, parser, "modifier");
        latest_name_ = p.modifier;
        latest_ = modifier;
    }
    std::vector<std::string_view> strings(p.strings.begin(), p.strings.end());

    if (p.type == PrimitiveType::alias) {
        PrimitiveId target = modifier_named(p.strings[0], parser, "target");
        while (scene_.type(target) == PrimitiveType::alias && scene_.strings(target).empty() &&
               scene_.modifier(target) != void_primitive)
            target = scene_.modifier(target);
        // A mere second name: the alias passes through to its target and needs no copy of it.
        if (inherits || modifier == scene_.modifier(target)) {
            modifier = target;
            strings.clear();
        }
    } else if (inherits) {
        throw Error(parser.location(), "\"inherit\" as the modifier of " + p.description(),
                    "only an alias can inherit its target's modifier");
    }
    if (info(p.type).is_modifier()) latest_ = void_primitive;
    scene_.add(p.type, modifier, p.name, strings, p.reals, {file, parser.line()});
}

}  // namespace

void read_rad(Scene& scene, const std::string& spec, const WarningSink& warn) {
    Reader(scene, warn).read_spec(spec);
}

void read_rad_text(Scene& scene, std::string_view text, const std::string& file_name,
                   const WarningSink& warn) {
    Reader(scene, warn).read(TextSource(text, file_name));
}

}  // namespace infra
