// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/PlyReader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <vector>

namespace toile::io {
namespace {

enum class Scalar { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::optional<Scalar> scalarNamed(std::string_view name) {
    using enum Scalar;
    static constexpr std::array<std::pair<std::string_view, Scalar>, 16> names{{
        {"char", int8},
        {"int8", int8},
        {"uchar", uint8},
        {"uint8", uint8},
        {"short", int16},
        {"int16", int16},
        {"ushort", uint16},
        {"uint16", uint16},
        {"int", int32},
        {"int32", int32},
        {"uint", uint32},
        {"uint32", uint32},
        {"float", float32},
        {"float32", float32},
        {"double", float64},
        {"float64", float64},
    }};
    for (const auto& [text, scalar] : names)
        if (text == name) return scalar;
    return std::nullopt;
}

std::size_t sizeOf(Scalar scalar) {
    static constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(scalar)];
}

struct Property {
    std::string name;
    Scalar type = Scalar::float32;
    std::optional<Scalar> countType; ///< of a list
};

struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
};

struct Header {
    bool ascii = false;
    std::vector<Element> elements;
    std::size_t length = 0; ///< bytes up to the first value
};

/// The next word of a line, taken off it.
std::string_view word(std::string_view& line) {
    const auto first = std::min(line.find_first_not_of(" \t\r"), line.size());
    line.remove_prefix(first);
    const auto length = std::min(line.find_first_of(" \t\r"), line.size());
    const std::string_view taken = line.substr(0, length);
    line.remove_prefix(length);
    return taken;
}

template <class T>
std::optional<T> number(std::string_view text) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

class Reader {
public:
    Reader(std::string_view bytes, std::string file) : bytes_(bytes), file_(std::move(file)) {}

    Result<geometry::TriangleMesh> read() {
        auto header = readHeader();
        if (!header) return tl::unexpected(header.error());
        at_ = header->length;
        ascii_ = header->ascii;
        for (const Element& element : header->elements)
            if (auto done = readElement(element); !done) return tl::unexpected(done.error());
        if (mesh_.vertices.empty()) return broken("it has no vertices.");
        if (mesh_.triangles.empty()) return broken("it has no faces.");
        for (const auto& triangle : mesh_.triangles)
            for (const int corner : triangle)
                if (corner < 0 || corner >= static_cast<int>(mesh_.vertices.size()))
                    return broken("a face names a vertex that does not exist.");
        return std::move(mesh_);
    }

private:
    tl::unexpected<Error> broken(const std::string& what, int line = 0) const {
        return fail(ErrorCode::invalidInput, "Is not a sound PLY file: " + what, {.file = file_, .line = line});
    }

    Result<Header> readHeader() {
        Header header;
        bool formatKnown = false;
        std::size_t at = 0;
        for (int line = 1;; ++line) {
            const auto end = bytes_.find('\n', at);
            if (end == std::string_view::npos || at > 65536) return broken("its header has no end.", line);
            std::string_view rest = bytes_.substr(at, end - at);
            at = end + 1;
            const std::string_view key = word(rest);
            if (line == 1 && key != "ply") return broken("it does not begin with \"ply\".", line);
            if (key == "end_header") break;
            if (key == "format") {
                const std::string_view kind = word(rest);
                if (kind != "ascii" && kind != "binary_little_endian")
                    return fail(ErrorCode::unsupported, "Only ASCII and little-endian PLY files are read.",
                                {.file = file_, .line = line});
                header.ascii = kind == "ascii";
                formatKnown = true;
            } else if (key == "element") {
                const std::string name(word(rest));
                const auto count = number<std::size_t>(word(rest));
                if (!count) return broken("the count of an element is no number.", line);
                header.elements.push_back({name, *count, {}});
            } else if (key == "property") {
                if (header.elements.empty()) return broken("a property stands before the first element.", line);
                auto property = readProperty(rest);
                if (!property) return broken("a property is of no known type.", line);
                header.elements.back().properties.push_back(std::move(*property));
            }
        }
        if (!formatKnown) return broken("its format is not stated.");
        header.length = at;
        return header;
    }

    static std::optional<Property> readProperty(std::string_view rest) {
        std::string_view type = word(rest);
        std::optional<Scalar> countType;
        if (type == "list") {
            countType = scalarNamed(word(rest));
            if (!countType) return std::nullopt;
            type = word(rest);
        }
        const auto scalar = scalarNamed(type);
        if (!scalar) return std::nullopt;
        return Property{std::string(word(rest)), *scalar, countType};
    }

    Result<void> readElement(const Element& element) {
        std::size_t least = 0; // bytes one of it takes at least
        for (const Property& p : element.properties) least += ascii_ ? 2 : sizeOf(p.countType.value_or(p.type));
        const std::size_t left = bytes_.size() - at_ + 1; // the last line may lack its end
        if (least == 0 ? element.count > 0 : element.count > left / least)
            return broken("it ends before all of \"" + element.name + "\" is there.");
        if (element.count > static_cast<std::size_t>(std::numeric_limits<int>::max()))
            return fail(ErrorCode::tooLarge, "Has more elements than can be counted.", {.file = file_});
        if (element.name == "vertex") mesh_.vertices.reserve(element.count);
        for (std::size_t i = 0; i < element.count; ++i)
            if (auto done = readRow(element); !done) return done;
        return {};
    }

    Result<void> readRow(const Element& element) {
        const bool isVertex = element.name == "vertex", isFace = element.name == "face";
        Vec3 position;
        for (const Property& property : element.properties) {
            if (!property.countType) {
                const auto v = value(property.type);
                if (!v) return broken("it ends, or has no number, in the middle of \"" + element.name + "\".");
                if (isVertex && property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z')
                    position[property.name[0] - 'x'] = *v;
                continue;
            }
            const auto count = value(*property.countType);
            const std::size_t each = ascii_ ? 2 : sizeOf(property.type);
            if (!count || *count < 0 || *count > static_cast<double>((bytes_.size() - at_ + 1) / each))
                return broken("a list of \"" + element.name + "\" is longer than the file.");
            list_.clear();
            for (int k = 0; k < *count; ++k) {
                const auto v = value(property.type);
                if (!v) return broken("it ends, or has no number, in the middle of \"" + element.name + "\".");
                list_.push_back(*v);
            }
            if (isFace && (property.name == "vertex_indices" || property.name == "vertex_index"))
                if (!addFan()) return broken("a face names a vertex that does not exist.");
        }
        if (isVertex) mesh_.vertices.push_back(position);
        return {};
    }

    /// The polygon in list_ as triangles round its first corner.
    bool addFan() {
        for (const double corner : list_)
            if (!(corner >= 0 && corner < 2147483647.0)) return false;
        for (std::size_t k = 2; k < list_.size(); ++k)
            mesh_.triangles.push_back(
                {static_cast<int>(list_[0]), static_cast<int>(list_[k - 1]), static_cast<int>(list_[k])});
        return true;
    }

    std::optional<double> value(Scalar type) { return ascii_ ? asciiValue() : binaryValue(type); }

    std::optional<double> asciiValue() {
        at_ = std::min(bytes_.find_first_not_of(" \t\r\n", at_), bytes_.size());
        const auto end = std::min(bytes_.find_first_of(" \t\r\n", at_), bytes_.size());
        const auto read = number<double>(bytes_.substr(at_, end - at_));
        at_ = end;
        return read;
    }

    template <class T>
    double raw() {
        T v;
        std::memcpy(&v, bytes_.data() + at_, sizeof v);
        at_ += sizeof v;
        return static_cast<double>(v);
    }

    std::optional<double> binaryValue(Scalar type) {
        if (bytes_.size() - at_ < sizeOf(type)) return std::nullopt;
        switch (type) {
        case Scalar::int8: return raw<std::int8_t>();
        case Scalar::uint8: return raw<std::uint8_t>();
        case Scalar::int16: return raw<std::int16_t>();
        case Scalar::uint16: return raw<std::uint16_t>();
        case Scalar::int32: return raw<std::int32_t>();
        case Scalar::uint32: return raw<std::uint32_t>();
        case Scalar::float32: return raw<float>();
        case Scalar::float64: return raw<double>();
        }
        return std::nullopt;
    }

    std::string_view bytes_;
    std::string file_;
    std::size_t at_ = 0;
    bool ascii_ = false;
    std::vector<double> list_;
    geometry::TriangleMesh mesh_;
};

} // namespace

Result<geometry::TriangleMesh> meshFromPly(std::string_view bytes, const std::string& file) {
    return Reader(bytes, file).read();
}

} // namespace toile::io
