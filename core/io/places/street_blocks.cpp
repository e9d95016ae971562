#include "core/io/places/place_assembly.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <iterator>
#include <map>
#include <numbers>
#include <set>
#include <string_view>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/receivers/made_names.h"

namespace noonmark {

namespace {

/// Points of lines in centimetres: those of one junction are equal, as they come from one node of the map.
using Node = std::pair<std::int64_t, std::int64_t>;

Node nodeAt(glm::dvec2 point) { return {std::llround(point.x * 100), std::llround(point.y * 100)}; }

/// Numbers within names by their value: "9th Avenue" before "10th Avenue".
bool precedes(const std::string& a, const std::string& b) {
    const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    const auto numberAt = [&](const std::string& text, std::size_t at) {
        std::size_t end = at;
        while (end < text.size() && isDigit(text[end])) ++end;
        while (at + 1 < end && text[at] == '0') ++at;
        return text.substr(at, end - at);
    };
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
        if (isDigit(a[i]) && isDigit(b[j])) {
            const std::string one = numberAt(a, i), other = numberAt(b, j);
            if (one.size() != other.size()) return one.size() < other.size();
            if (one != other) return one < other;
            while (i < a.size() && isDigit(a[i])) ++i;
            while (j < b.size() && isDigit(b[j])) ++j;
        } else {
            if (a[i] != b[j]) return a[i] < b[j];
            ++i, ++j;
        }
    }
    return a < b;
}

/// A part of a line between two points at which its street is cut, or to the line's end.
struct Stretch {
    std::size_t piece = 0;  ///< of which line
    std::vector<glm::dvec2> points;
    double lengthM = 0;
};

/// A connected piece of a street between two of its junctions.
struct Run {
    std::vector<std::size_t> stretches;
    std::map<Node, std::string> ends;  ///< junctions, each with its cross street
    double lengthM = 0;
};

/// The streets that share each node, by name.
using Crossings = std::map<Node, std::set<std::string>>;

Crossings findCrossings(const std::vector<StreetPiece>& pieces) {
    Crossings crossings;
    for (const StreetPiece& piece : pieces)
        if (!piece.name.empty())
            for (const glm::dvec2 point : piece.line.points) crossings[nodeAt(point)].insert(piece.name);
    std::erase_if(crossings, [](const auto& node) { return node.second.size() < 2; });
    return crossings;
}

double lengthOf(const std::vector<glm::dvec2>& points) {
    double sum = 0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += glm::distance(points[i - 1], points[i]);
    return sum;
}

/// Cuts one street.
class StreetCut {
public:
    StreetCut(const std::vector<StreetPiece>& pieces, std::vector<std::size_t> own,
              const Crossings& crossings)
        : pieces_(pieces), own_(std::move(own)), crossings_(crossings), name_(pieces[own_.front()].name) {}

    std::vector<StreetBlock> blocks() {
        for (const std::size_t piece : own_) cutLine(piece);
        joinRuns();
        while (joinInnerRun()) {
        }
        std::vector<StreetBlock> blocks;
        for (const Run& run : runs_) blocks.push_back(blockOf(run));
        return blocks;
    }

private:
    [[nodiscard]] bool isJunction(Node node) const { return crossings_.contains(node); }

    // The first of the streets that meet there.
    [[nodiscard]] std::string crossStreetAt(Node node) const {
        std::string first;
        for (const std::string& name : crossings_.at(node))
            if (name != name_ && (first.empty() || precedes(name, first))) first = name;
        return first;
    }

    void cutLine(std::size_t piece) {
        std::vector<glm::dvec2> points;
        const auto end = [&] {
            if (points.size() > 1) stretches_.push_back({piece, points, lengthOf(points)});
            points.clear();
        };
        for (const glm::dvec2 point : pieces_[piece].line.points) {
            points.push_back(point);
            if (!isJunction(nodeAt(point))) continue;
            end();
            points.push_back(point);
        }
        end();
    }

    // Stretches that share a point which is no junction hang together.
    void joinRuns() {
        DisjointSets joined(stretches_.size());
        std::map<Node, std::size_t> firstAt;
        for (std::size_t i = 0; i < stretches_.size(); ++i)
            for (const glm::dvec2 point : stretches_[i].points) {
                const Node node = nodeAt(point);
                if (isJunction(node)) continue;
                const auto [first, isNew] = firstAt.emplace(node, i);
                if (!isNew) joined.join(i, first->second);
            }
        for (const std::vector<std::size_t>& stretches : joined.list()) {
            Run& run = runs_.emplace_back();
            for (const std::size_t one : stretches) addTo(run, one);
        }
    }

    void addTo(Run& run, std::size_t stretch) const {
        const Stretch& own = stretches_[stretch];
        run.stretches.push_back(stretch);
        run.lengthM += own.lengthM;
        for (const glm::dvec2 point : {own.points.front(), own.points.back()})
            if (const Node node = nodeAt(point); isJunction(node))
                run.ends.emplace(node, crossStreetAt(node));
    }

    // Whether a run lies within a junction: between the carriageways of one cross street.
    [[nodiscard]] static bool isInner(const Run& run) {
        constexpr double longestM = 60;
        if (run.ends.size() < 2 || run.lengthM > longestM) return false;
        return std::ranges::all_of(run.ends,
                                   [&](const auto& end) { return end.second == run.ends.begin()->second; });
    }

    [[nodiscard]] static bool meet(const Run& a, const Run& b) {
        return std::ranges::any_of(a.ends, [&](const auto& end) { return b.ends.contains(end.first); });
    }

    // Adds a run within a junction to the longest beside it. Its outer ends become those of that one.
    bool joinInnerRun() {
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            if (!isInner(runs_[i])) continue;
            std::size_t longest = i;
            for (std::size_t j = 0; j < runs_.size(); ++j)
                if (j != i && !isInner(runs_[j]) && meet(runs_[i], runs_[j]) &&
                    (longest == i || runs_[j].lengthM > runs_[longest].lengthM))
                    longest = j;
            if (longest == i) continue;
            Run& to = runs_[longest];
            to.stretches.insert(to.stretches.end(), runs_[i].stretches.begin(), runs_[i].stretches.end());
            to.lengthM += runs_[i].lengthM;
            to.ends.insert(runs_[i].ends.begin(), runs_[i].ends.end());
            runs_.erase(runs_.begin() + std::ptrdiff_t(i));
            return true;
        }
        return false;
    }

    [[nodiscard]] StreetBlock blockOf(const Run& run) const {
        const StreetPiece& first = pieces_[stretches_[run.stretches.front()].piece];
        StreetBlock block{nameOf(run), first.id, 0, {}};
        std::set<std::size_t> lines;
        for (const std::size_t stretch : run.stretches) {
            const Stretch& own = stretches_[stretch];
            lines.insert(own.piece);
            block.lines.push_back({own.points, pieces_[own.piece].line.widthM});
        }
        block.lineCount = lines.size();
        return block;
    }

    [[nodiscard]] std::string nameOf(const Run& run) const {
        std::vector<std::string> cross = crossStreetsOf(run);
        if (cross.empty()) return name_;
        if (cross.size() == 1 && hasOpenEnd(run))
            return makeName(madeNames::winds[windOf(run)], {name_, cross[0]});
        if (cross.size() == 1) return makeName(madeNames::at, {name_, cross[0]});
        if (precedes(cross[1], cross[0])) std::swap(cross[0], cross[1]);
        return makeName(madeNames::between, {name_, cross[0], cross[1]});
    }

    // At most two: where a run branches, those of the ends that lie farthest apart.
    [[nodiscard]] static std::vector<std::string> crossStreetsOf(const Run& run) {
        std::set<std::string> names;
        for (const auto& [node, name] : run.ends) names.insert(name);
        if (names.size() <= 2) return {names.begin(), names.end()};
        std::vector<std::string> farthest;
        double maxCm = -1;
        for (const auto& [a, nameA] : run.ends)
            for (const auto& [b, nameB] : run.ends) {
                const double cm = std::hypot(double(a.first - b.first), double(a.second - b.second));
                if (nameA == nameB || cm <= maxCm) continue;
                maxCm = cm;
                farthest = {nameA, nameB};
            }
        return farthest;
    }

    // Where the run leads from its junction, by the frame's north: an index of madeNames::winds.
    [[nodiscard]] std::size_t windOf(const Run& run) const {
        const Node& from = run.ends.begin()->first;
        const glm::dvec2 junction = glm::dvec2(double(from.first), double(from.second)) / 100.0;
        glm::dvec2 farthest(0);
        for (const std::size_t stretch : run.stretches)
            for (const glm::dvec2 point : stretches_[stretch].points)
                if (glm::length(point - junction) > glm::length(farthest)) farthest = point - junction;
        const double eighths = std::atan2(farthest.y, farthest.x) / (std::numbers::pi / 4);
        return std::size_t(std::lround(eighths) + 8) % 8;
    }

    // Whether a stretch ends where nothing else of the street goes on.
    [[nodiscard]] bool hasOpenEnd(const Run& run) const {
        std::map<Node, int> visits;
        for (const std::size_t stretch : run.stretches)
            for (const glm::dvec2 point : stretches_[stretch].points) ++visits[nodeAt(point)];
        return std::ranges::any_of(run.stretches, [&](std::size_t stretch) {
            const auto& points = stretches_[stretch].points;
            return std::ranges::any_of(std::array{nodeAt(points.front()), nodeAt(points.back())},
                                       [&](Node node) { return visits[node] == 1 && !isJunction(node); });
        });
    }

    const std::vector<StreetPiece>& pieces_;
    std::vector<std::size_t> own_;  // lines of this street
    const Crossings& crossings_;
    std::string name_;
    std::vector<Stretch> stretches_;
    std::vector<Run> runs_;
};

}  // namespace

std::vector<StreetBlock> joinByName(const std::vector<StreetPiece>& pieces) {
    std::map<std::string, StreetBlock> byName;
    for (const StreetPiece& piece : pieces) {
        // A name cannot begin with a line break, so that lines without one stay apart.
        StreetBlock& street = byName[piece.name.empty() ? "\n" + piece.id : piece.name];
        if (street.lines.empty()) street = {piece.name, piece.id, 0, {}};
        street.lines.push_back(piece.line);
        ++street.lineCount;
    }
    std::vector<StreetBlock> streets;
    for (auto& [name, street] : byName) streets.push_back(std::move(street));
    return streets;
}

std::vector<StreetBlock> cutAtJunctions(const std::vector<StreetPiece>& pieces) {
    std::map<std::string, std::vector<std::size_t>, decltype(&precedes)> byName(&precedes);
    std::vector<StreetPiece> unnamed;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (pieces[i].name.empty())
            unnamed.push_back(pieces[i]);
        else
            byName[pieces[i].name].push_back(i);
    const Crossings crossings = findCrossings(pieces);
    std::vector<StreetBlock> blocks = joinByName(unnamed);
    for (const auto& [name, own] : byName) {
        auto ofStreet = StreetCut(pieces, own, crossings).blocks();
        std::ranges::stable_sort(ofStreet, precedes, &StreetBlock::name);
        std::ranges::move(ofStreet, std::back_inserter(blocks));
    }
    return blocks;
}

}  // namespace noonmark
