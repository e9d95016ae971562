#pragma once

// The folder core/city/trees is the model of trees: a Tree (this file) is a crown on a trunk. tree_facts.h is
// what data state of one and what is taken where they state nothing, Crown how much of a ray
// a crown takes.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/base/warnings.h"

namespace noonmark {

enum class CrownShape : std::uint8_t { ellipsoid, cone, cylinder };
/// "ellipsoid", "cone", "cylinder": the names used in files.
std::string_view nameOf(CrownShape shape);
std::optional<CrownShape> parseCrownShape(std::string_view name);

/// Origin of a tree's height or of its crown's diameter.
enum class TreeSource : std::uint8_t {
    measured,   ///< stated in the data
    estimated,  ///< from another measure of the tree (resources/trees/defaults.json)
    assumed,    ///< nothing in the data; the default of its group
    designed,   ///< stated by the user
};
/// All values, in the order in which they are counted.
inline constexpr std::array treeSources{TreeSource::measured, TreeSource::estimated, TreeSource::assumed,
                                        TreeSource::designed};
/// "measured", "estimated", "assumed", "designed".
std::string_view nameOf(TreeSource source);
std::optional<TreeSource> parseTreeSource(std::string_view name);

/// Days of the year between which a tree is in leaf, 1 to 366: from `on`, up to and without `off`. Where `on`
/// is the later one, leaves last over the new year. Equal days: always in leaf.
struct LeafDays {
    int on = 1;
    int off = 1;
    [[nodiscard]] bool inLeafOn(int dayOfYear) const {
        if (on == off) return true;
        return on < off ? dayOfYear >= on && dayOfYear < off : dayOfYear >= on || dayOfYear < off;
    }
    bool operator==(const LeafDays&) const = default;
};

/// The day of a common year of "04-15", 1 to 365, and back; 366 is written as 12-31. Error: no such day.
Result<int> parseDayOfYear(std::string_view text);
std::string formatDayOfYear(const int& dayOfYear);

/// One tree. Lengths are metres. Its trunk casts no shadow.
struct Tree {
    std::string sourceId;  ///< the feature it was read from: "node 2583920"
    std::string species;   ///< as the source states it; may be empty
    glm::dvec2 place{};    ///< local metres
    float groundM = 0;     ///< local z of its foot
    float heightM = 0;     ///< above its foot; > crownBaseM
    float crownBaseM = 0;  ///< above its foot, at least 0
    float crownDiameterM = 0;
    CrownShape shape = CrownShape::ellipsoid;
    bool evergreen = false;
    TreeSource heightSource = TreeSource::assumed;
    TreeSource crownSource = TreeSource::assumed;
    /// Share of the sun that passes the crown on a mean chord, 0 to 1, in leaf and without.
    float leafOnTransmissivity = 0;
    float leafOffTransmissivity = 0;
    /// First day in leaf and first day without leaves, 1 to 366; none: that of the city's trees.
    std::optional<int> leafOnDay = std::nullopt, leafOffDay = std::nullopt;

    bool operator==(const Tree&) const = default;
};

template <class S>
class Fields;
/// The fields of a tree but `groundM`, for files: the place in local metres, lengths in metres.
const Fields<Tree>& treeRecordFields();

/// When a tree that is not evergreen has its leaves: on its own days, where it states some.
LeafDays leafDaysOf(const Tree& tree, const LeafDays& ofCity);

/// The leaf days of some trees of a city, each pair once: the city's are number 0.
class LeafSeasons {
public:
    explicit LeafSeasons(const LeafDays& ofCity) : days_{ofCity} {}
    /// The number of a tree's days; 0 for evergreens.
    std::uint32_t add(const Tree& tree);
    /// The number of a tree that was added.
    [[nodiscard]] std::uint32_t of(const Tree& tree) const;
    [[nodiscard]] const std::vector<LeafDays>& days() const { return days_; }
    /// Whether all trees follow the city's days.
    [[nodiscard]] bool isUniform() const { return days_.size() == 1; }

private:
    std::vector<LeafDays> days_;
    std::map<std::pair<int, int>, std::uint32_t> numbers_;  ///< of days that are not the city's
};

/// The trees of a city: immutable as its buildings are.
struct Trees {
    std::vector<Tree> trees;
    LeafDays leafDays;  ///< of those that are not evergreen and state no days of their own
    /// Whether engines weigh them. Only questions that measure with trees set it (treesNotMeasured); the
    /// fields of all others are those without trees.
    bool weighed = false;

    bool operator==(const Trees&) const = default;
};

/// Leaf-on and leaf-off of a latitude, where none are stated: an assumption (docs/trees.md).
LeafDays assumeLeafDays(double latDeg);

/// Why trees are left out by the questions that measure without them: all but studies, comparisons and sun by
/// place.
inline constexpr std::string_view treesNotMeasured =
    "this question measures the shadow of buildings and terrain only";

/// The warning that trees are left out; `where`: "2931 trees", "in 3 tiles".
Warning makeTreeWarning(std::string where, std::string_view why = treesNotMeasured);

/// The same about the trees of a city, with their number. None where there are none.
Warnings warnOfTrees(const std::shared_ptr<const Trees>& trees, std::string_view why = treesNotMeasured);

/// A crown as rays meet it: around its vertical axis, between two elevations. An ellipsoid fills that height,
/// a cone has its apex at the top, a cylinder is as wide everywhere.
struct Crown {
    double x = 0, y = 0;           ///< local metres of its axis
    double bottomM = 0, topM = 0;  ///< local z; topM > bottomM
    double radiusM = 0;            ///< > 0
    CrownShape shape = CrownShape::ellipsoid;
    double leafOnPerM = 0;     ///< optical depth of a metre of path in leaf
    double leafOffPerM = 0;    ///< and out of season; of evergreens the same
    std::uint32_t season = 0;  ///< LeafSeasons: 0 the city's
};

/// The crown of a tree. The optical depth of a metre is -ln(transmissivity) / the crown's mean chord.
Crown makeCrown(const Tree& tree);

/// Mean length of the chords of a crown by lines of all places and directions, metres: 4 x volume / surface
/// (Cauchy).
double computeMeanChord(CrownShape shape, double radiusM, double heightM);

/// A part of a line, in lengths of its direction from its origin; empty unless `leave` > `enter`.
struct LinePart {
    double enter = 0, leave = 0;
};
/// The part of a line that lies in the crown. Exact to about 1e-12 of the distance. Some 10 ns.
LinePart findLinePart(const Crown& crown, glm::dvec3 origin, glm::dvec3 direction);

/// A normal of the crown's surface at a point of it, outward, of any length.
glm::dvec3 normalAt(const Crown& crown, glm::dvec3 point);

/// Length of the ray's path through the crown, metres, from its origin on: an origin inside the crown has the
/// rest of the chord only. `direction`: a unit vector.
double computeChord(const Crown& crown, glm::dvec3 origin, glm::dvec3 direction);

}  // namespace noonmark
