#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/engines/common/changed_buildings.h"
#include "core/engines/horizon/geometry/shadow_axes.h"
#include "core/engines/horizon/geometry/wall_list.h"
#include "core/engines/horizon/overhangs/overhang_layers.h"

namespace noonmark {

/// The overhangs of a city that changes by a few buildings at a time.
class OverhangCache {
public:
    [[nodiscard]] bool empty() const { return shapes_.empty(); }

    /// Number of overhang shapes of buildings that may shade the grid's cells from suns of this tangent or
    /// higher, at any azimuth. `but`: owners to exclude, ascending.
    [[nodiscard]] std::size_t reaching(const Grid& grid, double lowestTan,
                                       std::span<const std::uint64_t> but = {}) const;
    void add(OverhangShapes shapes, std::uint64_t owner);
    std::vector<OverhangShapes> remove(std::span<const std::uint64_t> owners);

    /// Overhangs of buildings that may shade cells within an extent from suns of this tangent or higher.
    /// Replaces the contents of `list`. `alongPerMetre`: cells along per metre of distance.
    void across(const ShadowAxes& axes, const ShadowExtent& extent, double lowestTan, double alongPerMetre,
                OverhangList& list) const;

private:
    std::vector<OverhangShapes> shapes_;
    std::vector<std::uint64_t> owners_;  // one per entry; ascending
};

/// Occluders that a city lost or gained.
struct WallSet {
    std::vector<StandingPrism> prisms;  ///< their walls are in the list that was changed
    std::vector<StandingSolid> solids;
    std::vector<OverhangShapes> overhangs;

    [[nodiscard]] Obstacles obstacles() const { return {prisms, solids}; }
};

struct WallChange {
    WallSet removed, added;
    /// The removed buildings are exactly those that the previous change added; all others are as before that
    /// change.
    bool undoesLast = false;
};

/// The occluders of a city that changes by a few buildings at a time. Buildings are distinguished by address,
/// since an edited city shares unchanged buildings with its predecessor.
class WallCache {
public:
    static WallCache of(const City& city, const Receivers& receivers);

    /// Error if more overhangs than OverhangShapes::maximum are in reach of suns of this tangent or higher.
    [[nodiscard]] Result<void> check(double lowestTan) const {
        return checkOverhangCount(overhangs_.reaching(grid_, lowestTan));
    }

    [[nodiscard]] const WallList& list() const { return list_; }
    [[nodiscard]] const OverhangCache& overhangs() const { return overhangs_; }
    /// Whether update() to this city is possible: the terrain is the same, and heights have the same datum.
    [[nodiscard]] bool sameGround(const City& city, const Receivers& receivers) const;
    [[nodiscard]] std::size_t buildings() const { return buildings_.size(); }

    /// Updates the occluders to those of `city`. One comparison per building, and another 0.5 ms for 43,000
    /// buildings unless the removed buildings are those added last. Error as of check(); then nothing is
    /// changed.
    Result<WallChange> update(const City& city, double lowestTan);

    /// The occluders without the buildings added last: `prisms`, and everything that is not indexed by
    /// location.
    [[nodiscard]] Obstacles before(std::span<const StandingPrism> prisms) const {
        return {prisms, std::span(list_.solids).first(solidsBefore_), list_.terrain.get()};
    }
    /// The prisms among these that overlap an extent in q, at any `along`. Replaces the contents of `prisms`.
    /// Some 5 us for 43,000.
    void across(const ShadowAxes& axes, const ShadowExtent& extent, std::vector<StandingPrism>& prisms) const;

private:
    explicit WallCache(const Grid& grid) : grid_(grid) {}
    using Owners = std::vector<std::uint64_t>;  // ascending

    /// Walls and overhangs of some buildings, numbered by their order.
    struct AddedWalls {
        WallList list;
        std::vector<OverhangShapes> overhangs;
    };
    [[nodiscard]] AddedWalls collectWalls(const Buildings& buildings) const;
    WallChange replace(const ChangedBuildings& changed, AddedWalls more, const Buildings& now);
    [[nodiscard]] Owners ownersOf(const Buildings& buildings) const;
    WallSet add(WallList more, std::vector<OverhangShapes> overhangs);
    WallSet remove(const Owners& owners);
    void forget(const Building* building, const Owners& owners);
    [[nodiscard]] bool wereAddedLast(const Owners& owners) const;
    void compactWalls();
    void rememberCounts(bool undoesLast);
    void updateCircles();
    void updateSquares();

    Grid grid_;
    std::shared_ptr<const Terrain> terrain_;
    Buildings buildings_;
    WallList list_;
    OverhangCache overhangs_;
    std::vector<std::uint64_t> owners_;  // for each prism, the serial number of its building
    std::vector<std::uint64_t> solidOwners_;
    std::unordered_multimap<const Building*, std::uint64_t> numbers_;
    std::uint64_t next_ = 0, firstOfLast_ = 0;  // the buildings added last: [firstOfLast_, next_)
    std::size_t solidsBefore_ = 0;              // their solids come after these
    std::size_t wallsUsed_ = 0;                 // walls of list_ in use
    /// A circle around a prism, or around all prisms of a square of the index; in cells.
    struct Circle {
        float x, y, radius;
        [[nodiscard]] bool reaches(float tilt, bool swapped, float middle, float half) const;
    };
    struct Square {
        Circle around{};
        std::uint32_t first = 0, end = 0;  // indices into order_
    };
    std::vector<Circle> circles_;       // one per prism, without the buildings added last
    std::vector<std::uint32_t> order_;  // prisms, square by square
    std::vector<Square> squares_;
};

}  // namespace noonmark
