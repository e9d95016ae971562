#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "app/gui/base/jobs/job.h"
#include "app/gui/tools/live/live_change.h"
#include "core/engines/ray/ray_scene.h"
#include "core/engines/trees/crowns.h"
#include "core/study/study.h"

// The shade of trees while they are dragged or planted, on the cells of a study: what it measured with trees,
// less what the dragged ones took where they stood, and what they take where they are.
namespace noonmark {

/// Suns of a period that crowns take for one, and how many minutes a day they count in the mean.
struct WeightedSun {
    glm::dvec3 direction{0, 0, 1};
    bool inLeaf = true;     ///< as CrownScene::inLeaf
    std::size_t phase = 0;  ///< LeafPhases
    double minutesPerDay = 0;
};
/// At most `maximum` of the patches of SunPatches, of 0.5 deg a side or of as little more as that takes.
/// `leaves`: null: trees are in leaf all year. `phases`: of the same steps, where trees have leaf days of
/// their own.
std::vector<WeightedSun> findSuns(const SunSteps& sun, const LeafDays* leaves, std::size_t maximum,
                                  const LeafPhases& phases = {});

/// The crowns that stay, in squares of the ground: those that a ray meets are found along it.
class StandingCrowns {
public:
    explicit StandingCrowns(const std::vector<Crown>& crowns);
    /// What the paths of a ray towards a sun through them add up to, by metre and optical depth of a metre.
    [[nodiscard]] double depth(glm::dvec3 origin, const WeightedSun& sun, const LeafPhases& phases) const;

private:
    using Square = std::pair<int, int>;
    static Square squareOf(glm::dvec2 place);
    std::map<Square, std::vector<Crown>> squares_;  // by the middle of each crown
    double highestM_ = 0, widestM_ = 0;
};

/// Trees that follow the hand.
struct HandledTrees {
    std::set<std::string> moved;  ///< ids of those of the city that are dragged
    std::optional<Tree> planted;  ///< the measures of those that are planted; its place means nothing
};
/// Where they are.
struct HandledPlaces {
    glm::dvec2 byM{0};                ///< of the dragged ones from their places
    std::vector<glm::dvec2> planted;  ///< local metres
};

/// Not thread-safe.
class LiveTreeShade {
public:
    /// Patches of the sun up to which a tree moved follows a hand.
    static constexpr std::size_t maxPatches = 600;
    static constexpr std::size_t maxMoved = 200;

    /// Error: none or too many trees are dragged, the study was asked for without trees, too little memory;
    /// cancelled(). Some 0.1 s for Midtown.
    static Result<std::shared_ptr<LiveTreeShade>> of(std::shared_ptr<const Study> study,
                                                     const HandledTrees& trees, const std::stop_token& stop);

    /// Gross shadow with trees by their seasons (or as evergreens, as the study has it). What was asked of
    /// the rest of the city is known the next time.
    [[nodiscard]] ShadowField with(const HandledPlaces& places);
    /// The same of the study itself.
    [[nodiscard]] const ShadowField& before() const { return *before_; }
    [[nodiscard]] bool isSeasonal() const { return seasonal_; }

    [[nodiscard]] std::size_t patches() const { return patches_.size(); }

private:
    LiveTreeShade(std::shared_ptr<const Study> study, RayScene scene, const std::vector<Crown>& others,
                  LeafSeasons seasons);
    [[nodiscard]] std::vector<Crown> crownsAt(const HandledPlaces& places) const;
    /// Minutes a day by cell, of some of the patches; the others of its rows are 0.
    struct Sums {
        std::vector<float> minutes;
        std::vector<float> depths;           ///< optical, of one patch; 0 between patches
        std::vector<std::uint32_t> touched;  ///< cells with a depth
        int firstRow = 0, lastRow = -1;
    };
    static constexpr std::size_t tasks = 4;
    [[nodiscard]] std::vector<float> measure(const std::vector<Crown>& crowns);
    void shade(const WeightedSun& patch, std::uint8_t* passed, const std::vector<Crown>& crowns,
               Sums& sums) const;
    template <class Visit>
    void visitShadow(const Crown& crown, glm::dvec3 direction, Visit&& visit) const;
    [[nodiscard]] double passOf(std::uint32_t cell, const WeightedSun& patch, std::uint8_t& known) const;

    std::shared_ptr<const Study> study_;
    const ShadowField* before_;  // of the study, with trees
    RayScene scene_;             // buildings and terrain
    StandingCrowns others_;
    std::vector<Tree> moved_;
    std::optional<Tree> planted_;
    bool seasonal_ = true;
    LeafSeasons seasons_;
    LeafPhases phases_;  // of the study's steps
    std::vector<WeightedSun> patches_;
    float lowestM_ = 0, highestM_ = 0;  // of the receivers
    std::vector<std::uint8_t> passed_;  // by patch and cell: share of the sun that the rest lets through
    std::array<Sums, tasks> sums_;      // 0 between calls
    std::vector<float> takenBefore_;    // by the moved trees where they stood, minutes a day
};

/// The shadow of a place with trees, minutes a day in the mean over its cells.
struct LivePlaceShade {
    std::string name;   ///< empty: the whole region
    bool whole = true;  ///< false: only as far as the study reaches
    double beforeMin = 0, nowMin = 0;
};
/// The region first, then the places, those that change most first. `places`: cells that are receivers.
/// O(cells).
std::vector<LivePlaceShade> comparePlaces(const Receivers& receivers, const std::vector<GridPlace>& places,
                                          const ShadowField& before, const ShadowField& now);

/// Keeps that shade up to date while trees are dragged or planted: one place is computed at a time, in a job;
/// of those that arrive meanwhile the newest is next.
class LiveTrees final : public QObject {
    Q_OBJECT
public:
    explicit LiveTrees(QObject* parent = nullptr) : QObject(parent) {}

    void begin(std::shared_ptr<const Study> study, HandledTrees trees, std::vector<Place> places = {});
    void follow(HandledPlaces places);  ///< does nothing before begin()
    void end();

    [[nodiscard]] std::shared_ptr<const ShadowField> field() const { return field_; }  ///< null: none yet
    /// What that field says of the region and of the places.
    [[nodiscard]] const std::vector<LivePlaceShade>& figures() const { return figures_; }
    [[nodiscard]] bool isSeasonal() const { return shade_ && shade_->isSeasonal(); }
    [[nodiscard]] std::shared_ptr<const Study> study() const { return study_; }
    [[nodiscard]] JobSlot& working() { return slot_; }

Q_SIGNALS:
    void changed();
    void failed(noonmark::Error error);

private:
    struct Followed {
        std::shared_ptr<LiveTreeShade> shade;
        std::shared_ptr<const std::vector<GridPlace>> cells;
        std::shared_ptr<const ShadowField> field;
        std::vector<LivePlaceShade> figures;
    };
    void ask();
    void take(Result<Followed> followed);

    std::shared_ptr<const Study> study_;
    HandledTrees trees_;
    std::shared_ptr<const std::vector<Place>> places_;
    std::shared_ptr<LiveTreeShade> shade_;
    std::shared_ptr<const std::vector<GridPlace>> cells_;  // of the places
    std::shared_ptr<const ShadowField> field_;
    std::vector<LivePlaceShade> figures_;
    HandledPlaces at_;
    bool newer_ = false;  // the place has changed since the running job began
    JobSlot slot_;
};

}  // namespace noonmark
