#include "core/mesh_reader/read_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <string_view>
#include <vector>

#include "core/mesh_reader/text_lines.h"

namespace noonmark {

namespace {

constexpr double farFromZero = 10'000;  // float32 then rounds to a thousandth
constexpr double farthestOnMaps = 1e12;
constexpr std::size_t sampled = 1000;

// Subtracts nothing, but remembers the first points; then subtracts their middle from each.
class PointMover {
public:
    // Whether the first points lie far from zero.
    bool decide() {
        for (int axis = 0; axis < 3; ++axis) origin_[axis] = std::round(middle(axis));
        const double maximum = std::max({std::abs(origin_.x), std::abs(origin_.y), std::abs(origin_.z)});
        return maximum > farFromZero && maximum < farthestOnMaps;
    }
    bool sample(glm::dvec3 point) {
        first_.push_back(point);
        return first_.size() < sampled;
    }
    [[nodiscard]] glm::dvec3 origin() const { return origin_; }
    [[nodiscard]] glm::dvec3 move(glm::dvec3 point) const { return point - origin_; }

private:
    double middle(int axis) {
        if (first_.empty()) return 0;
        const auto at = first_.begin() + std::ptrdiff_t(first_.size() / 2);
        std::nth_element(first_.begin(), at, first_.end(),
                         [&](const glm::dvec3& a, const glm::dvec3& b) { return a[axis] < b[axis]; });
        return (*at)[axis];
    }

    std::vector<glm::dvec3> first_;
    glm::dvec3 origin_{0};
};

// The point of a line, and what follows its numbers. Nothing where it is none.
struct LinePoint {
    glm::dvec3 point;
    std::string_view rest;
};

using Find = std::function<bool(std::string_view& line)>;  // takes what precedes a line's point

std::optional<LinePoint> pointOf(std::string_view line) {
    LinePoint found{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto number = takeNumber(line);
        if (!number) return std::nullopt;
        found.point[axis] = *number;
    }
    found.rest = line;
    return found;
}

void writePoint(std::string& text, std::string_view before, const glm::dvec3& point, std::string_view rest) {
    fmt::format_to(std::back_inserter(text), "{} {} {} {}{}\n", before, float(point.x), float(point.y),
                   float(point.z), rest);
}

// False where a line with a point cannot be read: the file then stays as it is.
bool samplePoints(std::string_view text, const Find& isPoint, PointMover& mover) {
    while (!text.empty()) {
        std::string_view line = takeLine(text);
        if (!isPoint(line)) continue;
        const auto found = pointOf(line);
        if (!found) return false;
        if (!mover.sample(found->point)) break;
    }
    return mover.decide();
}

std::string withMovedLines(std::string_view text, const Find& isPoint, const PointMover& mover) {
    std::string moved;
    moved.reserve(text.size());
    while (!text.empty()) {
        const std::string_view whole = takeLine(text);
        std::string_view line = whole;
        if (!isPoint(line)) {
            moved.append(whole).push_back('\n');
            continue;
        }
        const auto found = pointOf(line);
        if (!found) return {};
        writePoint(moved, whole.substr(0, whole.size() - line.size()), mover.move(found->point), found->rest);
    }
    return moved;
}

NearPoints moveLines(std::string_view text, const std::function<Find()>& lines) {
    PointMover mover;
    if (!samplePoints(text, lines(), mover)) return {};
    std::string moved = withMovedLines(text, lines(), mover);
    return moved.empty() ? NearPoints{} : NearPoints{std::move(moved), mover.origin()};
}

// Lines that begin with a word: "vertex" of STL.
std::function<Find()> linesAfter(std::string_view word) {
    return [word] {
        return [word](std::string_view& line) {
            std::string_view rest = line;
            const bool found = takeWord(rest) == word;
            if (found) line = rest;
            return found;
        };
    };
}

// Where a PLY keeps its points, as its header says.
struct PlyPoints {
    bool isText = false;
    std::endian order = std::endian::little;
    std::size_t count = 0;   // of the vertices, which come first
    std::size_t stride = 0;  // bytes of a vertex
    std::size_t begin = 0;   // of the first vertex in the file
    std::size_t x = 0;       // of x in a vertex: bytes; y and z follow at once
    bool isDouble = false;
    int columns = 0;  // properties before x
};

std::size_t bytesOfType(std::string_view type) {
    struct Type {
        std::string_view name;
        std::size_t bytes;
    };
    constexpr std::array types{Type{"char", 1},  Type{"uchar", 1},   Type{"int8", 1},   Type{"uint8", 1},
                               Type{"short", 2}, Type{"ushort", 2},  Type{"int16", 2},  Type{"uint16", 2},
                               Type{"int", 4},   Type{"uint", 4},    Type{"int32", 4},  Type{"uint32", 4},
                               Type{"float", 4}, Type{"float32", 4}, Type{"double", 8}, Type{"float64", 8}};
    const auto found = std::ranges::find(types, type, &Type::name);
    return found == types.end() ? 0 : found->bytes;
}

// Reads the header line by line; nothing where x, y and z do not follow each other in the first element.
class PlyHeader {
public:
    std::optional<PlyPoints> read(std::string_view text) {
        const std::size_t all = text.size();
        while (!text.empty()) {
            std::string_view line = takeLine(text);
            const std::string_view word = takeWord(line);
            if (word == "format") takeFormat(takeWord(line));
            if (word == "element") takeElement(line);
            if (word == "property" && elements_ == 1) takeProperty(line);
            if (word != "end_header") continue;
            points_.begin = all - text.size();
            return isGood_ && axes_ == 3 ? std::optional(points_) : std::nullopt;
        }
        return std::nullopt;
    }

private:
    void takeFormat(std::string_view word) {
        points_.isText = word == "ascii";
        points_.order = word == "binary_big_endian" ? std::endian::big : std::endian::little;
    }
    void takeElement(std::string_view line) {
        const bool isVertex = takeWord(line) == "vertex";
        if (++elements_ > 1) return;
        const auto count = takeNumber(line);
        isGood_ = isVertex && count && *count >= 0 && *count < 1e12;
        points_.count = isGood_ ? std::size_t(*count) : 0;
    }
    void takeProperty(std::string_view line) {
        constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
        const std::string_view type = takeWord(line), name = takeWord(line);
        const std::size_t bytes = bytesOfType(type);
        isGood_ = isGood_ && bytes > 0;  // a list has none
        if (axes_ < 3 && name == names[std::size_t(axes_)]) {
            if (axes_ == 0)
                points_.x = points_.stride, points_.columns = properties_, points_.isDouble = bytes == 8;
            isGood_ = isGood_ && properties_ == points_.columns + axes_ && points_.isDouble == (bytes == 8);
            ++axes_;
        }
        points_.stride += bytes;
        ++properties_;
    }

    PlyPoints points_;
    bool isGood_ = false;
    int elements_ = 0, properties_ = 0, axes_ = 0;
};

double numberAt(const char* bytes, std::endian order) {
    std::array<char, sizeof(double)> own{};
    std::memcpy(own.data(), bytes, own.size());
    if (order != std::endian::native) std::ranges::reverse(own);
    return std::bit_cast<double>(own);
}

void writeNumber(char* bytes, double number, std::endian order) {
    auto own = std::bit_cast<std::array<char, sizeof(double)>>(number);
    if (order != std::endian::native) std::ranges::reverse(own);
    std::memcpy(bytes, own.data(), own.size());
}

NearPoints moveBinaryPly(std::string text, const PlyPoints& points) {
    if (!points.isDouble || points.count > (text.size() - points.begin) / points.stride) return {};
    PointMover mover;
    const auto at = [&](std::size_t i) { return text.data() + points.begin + i * points.stride + points.x; };
    const auto pointAt = [&](std::size_t i) {
        glm::dvec3 point;
        for (int axis = 0; axis < 3; ++axis)
            point[axis] = numberAt(at(i) + std::size_t(axis) * sizeof(double), points.order);
        return point;
    };
    for (std::size_t i = 0; i < points.count && std::isfinite(pointAt(i).x + pointAt(i).y + pointAt(i).z);
         ++i)
        if (!mover.sample(pointAt(i))) break;
    if (!mover.decide()) return {};
    for (std::size_t i = 0; i < points.count; ++i) {
        const glm::dvec3 moved = mover.move(pointAt(i));
        for (int axis = 0; axis < 3; ++axis)
            writeNumber(at(i) + std::size_t(axis) * sizeof(double), moved[axis], points.order);
    }
    return {std::move(text), mover.origin()};
}

// The lines of the vertices, which follow the header.
std::function<Find()> linesOfPly(const PlyPoints& points) {
    return [points] {
        return [left = points.count, columns = points.columns](std::string_view& line) mutable {
            if (left == 0) return false;
            --left;
            for (int i = 0; i < columns; ++i) takeWord(line);
            return true;
        };
    };
}

NearPoints movePly(std::string text) {
    const auto points = PlyHeader().read(text);
    if (!points) return {};
    if (!points->isText) return moveBinaryPly(std::move(text), *points);
    NearPoints moved = moveLines(std::string_view(text).substr(points->begin), linesOfPly(*points));
    if (!moved.content.empty()) moved.content.insert(0, text, 0, points->begin);
    return moved;
}

std::string beginningOf(const std::filesystem::path& file) {
    std::string head(1024, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(head.data(), std::streamsize(head.size()));
    head.resize(std::size_t(stream.gcount()));
    return head;
}

}  // namespace

NearPoints movePointsNear(const std::filesystem::path& file) {
    const std::string head = beginningOf(file);
    if (head.starts_with("ply")) return movePly(readWholeFile(file));
    if (head.find('\0') != head.npos) return {};
    if (head.starts_with("solid")) return moveLines(readWholeFile(file), linesAfter("vertex"));
    return {};
}

}  // namespace noonmark
