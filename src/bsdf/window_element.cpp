#include "bsdf/window_element.h"

#include <algorithm>
#include <pugixml.hpp>

#include "common/format.h"
#include "common/parse_number.h"
#include "common/text.h"
#include "common/text_file.h"

namespace infra {
namespace {

constexpr int most_sectors = 1000;  // of a ring
constexpr std::size_t most_rings = 90;

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

/// Walks through the parsed file and knows the lines of its nodes.
class Reader {
  public:
    Reader(std::string_view text, const std::string& name) : text_(text), name_(name) {
        const auto result =
            document_.load_buffer(text.data(), text.size(), pugi::parse_cdata | pugi::parse_escapes);
        if (!result)
            throw Error(place_at(result.offset), std::string("bad XML: ") + result.description(),
                        "a BSDF file is XML as genBSDF and WINDOW write it");
    }

    WindowElement read();

  private:
    Location place_at(std::ptrdiff_t offset) const {
        const auto end = text_.begin() + std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(text_));
        return {name_, 1 + static_cast<int>(std::count(text_.begin(), end, '\n'))};
    }
    Location place(const pugi::xml_node& node) const { return place_at(node.offset_debug()); }
    /// Text of a child, without blanks around it; empty if there is none.
    static std::string text_of(const pugi::xml_node& node, const char* child) {
        return std::string(trimmed(node.child_value(child)));
    }
    double number_in(const pugi::xml_node& parent, const char* child) const;
    double metres(const pugi::xml_node& node) const;
    double length_of(const pugi::xml_node& material, const char* child) const;
    void describe(const pugi::xml_node& layer, BsdfDescription& result) const;
    AngleBasis angle_basis(const pugi::xml_node& node, const std::string& name) const;
    void add_bases(const pugi::xml_node& definition, std::vector<AngleBasis>& bases) const;
    void add_block(const pugi::xml_node& node, const std::string& wavelength,
                   std::vector<ScatteringBlock>& blocks) const;

    std::string_view text_;
    std::string name_;
    pugi::xml_document document_;
};

double Reader::number_in(const pugi::xml_node& parent, const char* child) const {
    const std::string text = text_of(parent, child);
    double value = 0;
    if (!parse_real(text, value))
        throw Error(place(parent), "<" + std::string(parent.name()) + "> has no number <" + child + ">");
    return value;
}

/// Of the unit that an element states.
double Reader::metres(const pugi::xml_node& node) const {
    const std::string_view unit = node.attribute("unit").value();
    if (unit.empty() || same_name(unit, "meter")) return 1;
    if (same_name(unit, "foot")) return 0.3048;
    if (same_name(unit, "inch")) return 0.0254;
    if (same_name(unit, "centimeter")) return 0.01;
    if (same_name(unit, "millimeter")) return 0.001;
    throw Error(place(node), "unknown unit \"" + std::string(unit) + "\"",
                "meter, centimeter, millimeter, foot or inch");
}

double Reader::length_of(const pugi::xml_node& material, const char* child) const {
    const pugi::xml_node node = material.child(child);
    if (!node) return 0;
    double value = 0;
    if (!parse_real(trimmed(node.child_value()), value) || value < 0)
        throw Error(place(node), "<" + std::string(child) + "> is not a length, 0 or more");
    return value * metres(node);
}

void Reader::describe(const pugi::xml_node& layer, BsdfDescription& result) const {
    const pugi::xml_node material = layer.child("Material");
    result.material = text_of(material, "Name");
    result.manufacturer = text_of(material, "Manufacturer");
    result.width = length_of(material, "Width");
    result.height = length_of(material, "Height");
    result.thickness = length_of(material, "Thickness");
    const pugi::xml_node geometry = layer.child("Geometry");
    const std::string_view format = geometry.attribute("format").value();
    if (!format.empty() && !same_name(format, "MGF"))
        throw Error(place(geometry), "geometry of the format \"" + std::string(format) + "\"",
                    "only MGF is known");
    if (const pugi::xml_node block = geometry.child("MGFblock")) {
        result.geometry = trimmed(block.child_value());
        result.geometry_unit = metres(block);
    }
}

AngleBasis Reader::angle_basis(const pugi::xml_node& node, const std::string& name) const {
    std::vector<AngleRing> rings;
    for (const pugi::xml_node block : node.children("AngleBasisBlock")) {
        const pugi::xml_node bounds = block.child("ThetaBounds");
        if (!bounds) throw Error(place(block), "<AngleBasisBlock> without <ThetaBounds>");
        const double upper = number_in(bounds, "UpperTheta");
        const double before = rings.empty() ? 0.0 : rings.back().upper_deg;
        const double lower = rings.empty() ? 0.0 : number_in(bounds, "LowerTheta");
        constexpr double tolerance = 1e-4;  // degrees
        if (!rings.empty() && std::abs(lower - before) > tolerance)
            throw Error(place(bounds),
                        formatted("LowerTheta %g where the ring before ends at %g", lower, before));
        if (!(upper > before) || upper > 90 + tolerance)
            throw Error(place(bounds), formatted("UpperTheta %g after %g", upper, before),
                        "they rise up to 90");
        int sectors = 0;
        if (!parse_int(text_of(block, "nPhis"), sectors) || sectors < 1 || sectors > most_sectors ||
            (sectors == 1 && before > 0))
            throw Error(place(block), "bad number of sectors <nPhis>",
                        formatted("1 in the middle, 2 to %d around it", most_sectors));
        rings.push_back({upper, sectors});
        if (rings.size() > most_rings)
            throw Error(place(block), formatted("more than %zu rings", most_rings));
    }
    if (rings.empty()) throw Error(place(node), "angle basis \"" + name + "\" without <AngleBasisBlock>");
    return AngleBasis(name, rings);
}

void Reader::add_bases(const pugi::xml_node& definition, std::vector<AngleBasis>& bases) const {
    for (const pugi::xml_node node : definition.children("AngleBasis")) {
        const std::string name = text_of(node, "AngleBasisName");
        const auto is_known = [&](const AngleBasis& basis) { return same_name(basis.name(), name); };
        if (name.empty() || standard_angle_basis(name) || std::ranges::any_of(bases, is_known)) continue;
        bases.push_back(angle_basis(node, name));
    }
}

void Reader::add_block(const pugi::xml_node& node, const std::string& wavelength,
                       std::vector<ScatteringBlock>& blocks) const {
    // WINDOW's front is the outside, ours the side that the normal points to: the inside.
    constexpr std::pair<const char*, ScatterSides> directions[] = {{"Transmission Front", {false, true}},
                                                                   {"Transmission Back", {true, true}},
                                                                   {"Reflection Front", {false, false}},
                                                                   {"Reflection Back", {true, false}}};
    const std::string name = text_of(node, "WavelengthDataDirection");
    for (const auto& [known, sides] : directions) {
        if (!same_name(name, known)) continue;
        const pugi::xml_node data = node.child("ScatteringData");
        if (trimmed(data.child_value()).empty())
            throw Error(place(data ? data : node), "no <ScatteringData> for \"" + name + "\"");
        blocks.push_back({place(node), wavelength, sides, text_of(node, "ColumnAngleBasis"),
                          text_of(node, "RowAngleBasis"), text_of(node, "AngleBasis"), data.child_value(),
                          place(data.first_child())});
    }
}

WindowElement Reader::read() {
    WindowElement result;
    const pugi::xml_node root = document_.document_element();
    result.place = place(root);
    if (std::string_view(root.name()) != "WindowElement")
        throw Error(result.place, "the file holds a <" + std::string(root.name()) + ">",
                    "a BSDF file holds a <WindowElement>");
    const std::string type = text_of(root, "FileType");
    if (root.child("FileType") && type != "BSDF")
        throw Error(place(root.child("FileType")), "the file's type is \"" + type + "\"", "it must be BSDF");
    const pugi::xml_node layer = root.child("Optical").child("Layer");
    if (!layer) throw Error(result.place, "no <Layer> of <Optical> data");
    describe(layer, result.description);
    const pugi::xml_node definition = layer.child("DataDefinition");
    result.data_structure = text_of(definition, "IncidentDataStructure");
    result.structure_place = place(definition ? definition : layer);
    if (result.data_structure.empty())
        throw Error(result.structure_place, "no <IncidentDataStructure>",
                    "Columns, Rows, TensorTree3 or TensorTree4");
    add_bases(definition, result.bases);
    for (const pugi::xml_node data : layer.children("WavelengthData"))
        for (const pugi::xml_node block : data.children("WavelengthDataBlock"))
            add_block(block, text_of(data, "Wavelength"), result.blocks);
    return result;
}

}  // namespace

WindowElement parse_window_element(std::string_view text, const std::string& name) {
    return Reader(text, name).read();
}

WindowElement read_window_element(const std::string& path) {
    return parse_window_element(read_text_file(path), path);
}

}  // namespace infra
