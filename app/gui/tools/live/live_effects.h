#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "app/gui/base/jobs/job.h"
#include "app/gui/session/study/shared_horizon_cache.h"
#include "app/gui/tools/live/live_shadow.h"
#include "core/base/progress.h"
#include "core/study/elements/element_map.h"

namespace noonmark {

// The live shadow: what an edit shades, while it is dragged. LiveFollower runs one computation at a time for
// the newest shape; LiveShadow computes it, with the receivers and the engine that live_shadow
// chooses. LiveFacades does the same for the sunlight of facades.
// SharedHorizonCache holds the horizons that the time sliders use too.

/// Keeps the shadow of a shape up to date while the user edits it. One shape is computed at a time, in a job;
/// when it is ready, the newest of the shapes that arrived meanwhile is next. While the shape moves only
/// gross shadow is computed; continuous shadow, where it costs more, when the shape rests.
class LiveFollower final : public QObject {
    Q_OBJECT
public:
    explicit LiveFollower(std::shared_ptr<SharedHorizonCache> horizons, QObject* parent = nullptr);

    void begin(LivePlace place, const LiveQuestion& question);  ///< cancels the work before
    void follow(const LiveReceivers::Shape& shape);             ///< does nothing before begin()
    void end();

    /// The latest answer since begin(); null if there is none yet.
    [[nodiscard]] std::shared_ptr<const LiveAnswer> answer() const { return answer_; }
    /// How long a shape newer than the answer's has been known, seconds; 0 if there is none.
    [[nodiscard]] double ageSeconds() const;
    [[nodiscard]] JobSlot& working() { return slot_; }

Q_SIGNALS:
    void changed();  ///< a new answer
    /// The answer is of an older shape than the newest; emitted several times a second while it is.
    void aged();
    /// Also if cancelled. Nothing is computed until the next begin().
    void failed(noonmark::Error error);

private:
    struct Start {
        LivePlace place;
        LiveQuestion question;
    };
    struct Followed {
        std::shared_ptr<LiveShadow> live;
        LiveAnswer answer;
    };
    void ask(ShadowCounts counts);
    void take(Result<Followed> followed);
    void rested();

    std::shared_ptr<SharedHorizonCache> horizons_;
    std::shared_ptr<const Start> start_;  // null: not active
    std::shared_ptr<LiveShadow> live_;    // null before the first answer
    std::shared_ptr<const LiveAnswer> answer_;
    LiveReceivers::Shape shape_;
    ShadowCounts asked_ = ShadowCounts::gross;  // of the running job
    QElapsedTimer newerThanAsked_;              // invalid: no newer shape
    QElapsedTimer newerThanShown_;
    QTimer rest_;
    QTimer age_;
    JobSlot slot_;
};

/// The facades whose sunlight is shown while a building is edited.
struct FacadeQuestion {
    using Buildings = std::vector<std::shared_ptr<const Building>>;

    std::shared_ptr<const City> rest;  ///< the city without the buildings that the edit replaces
    std::shared_ptr<const SunSteps> sun;
    FacadeSettings facades;
    Buildings shape;       ///< the edited buildings, not in `rest`
    Buildings neighbours;  ///< of `rest`, whose facades are shown too
    OwnStoreys storeys{};  ///< of the shape
};

/// The sunlight of these facades.
struct FacadeAnswer {
    ElementMap map;
    FacadeSettings facades;   ///< bays and storeys that were measured
    bool coarse = false;      ///< see measureFacadesCoarsely()
    double buildSeconds = 0;  ///< independent of the number of points
    double sweepSeconds = 0;
};

/// Measures every bay and storey. Error: what placeOnFacades() refuses, cancelled(). In Midtown some 0.3 s
/// and 1 ms a point for a year of minutes.
Result<FacadeAnswer> measureFacades(const FacadeQuestion& question, Progress& progress,
                                    const std::stop_token& stop);

/// The same while the shape moves: with bays and storeys so large that there are about `points`, and with
/// buildings only that rise above nearHorizonDeg or are within nearM of the shape. Sun below that altitude
/// may be missed, or counted where a far building hides it.
Result<FacadeAnswer> measureFacadesCoarsely(const FacadeQuestion& question, std::size_t points,
                                            Progress& progress, const std::stop_token& stop);
inline constexpr double nearHorizonDeg = 5, nearM = 150;

/// Keeps the sunlight of facades up to date while the user edits a building: coarsely while it moves, in
/// about a budget of time; every bay and storey when it rests. One question is computed at a time, in a job;
/// when it is ready, the newest of those that arrived meanwhile is next.
class LiveFacades final : public QObject {
    Q_OBJECT
public:
    static constexpr double budgetSeconds = 0.2;

    explicit LiveFacades(QObject* parent = nullptr);

    /// Ends what was followed before. `rest`: the city without the buildings that the edit replaces.
    void begin(City rest, const SunQuestion& sun, const FacadeSettings& facades);
    /// The edited buildings with their own storeys, and those of the city whose facades are shown too. Does
    /// nothing before begin().
    void follow(const FacadeQuestion::Buildings& shape, const FacadeQuestion::Buildings& neighbours,
                const OwnStoreys& storeys = {});
    void end();

    /// The latest answer since begin(); null if there is none yet.
    [[nodiscard]] std::shared_ptr<const FacadeAnswer> answer() const { return answer_; }
    [[nodiscard]] JobSlot& working() { return slot_; }

Q_SIGNALS:
    void changed();  ///< a new answer
    /// Also if cancelled. Nothing is computed until the next begin().
    void failed(noonmark::Error error);

private:
    struct Followed {
        std::shared_ptr<const SunSteps> sun;
        FacadeAnswer answer;
    };
    void ask(bool coarse);
    void take(Result<Followed> followed);
    void fitBudget(const FacadeAnswer& answer);

    std::optional<FacadeQuestion> question_;  // none: not active. Without the sun until it is computed
    SunQuestion sun_;
    std::shared_ptr<const FacadeAnswer> answer_;
    bool newer_ = false;  // the question has changed since the running job was asked
    bool coarse_ = true;  // of the running job
    std::size_t points_;  // that fit into the budget
    QTimer rest_;
    JobSlot slot_;
};

}  // namespace noonmark
