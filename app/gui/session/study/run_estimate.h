#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "app/gui/base/jobs/job.h"
#include "core/study/by_place/sun_by_place.h"
#include "core/study/elements/place_elements.h"

class QTimer;

namespace noonmark {

/// The expected cost of one field, with its months and contributions where these are wanted, on two cores, by
/// the model that the automatic engine chooses with (auto_engine.h). For accrual maps and the direction graph
/// scaled from rays by the ratios of docs/benchmarks.md, within a factor of about two.
struct RunEstimate {
    double receivers = 0;
    bool points = false;        ///< the receivers are points, not cells
    double steps = 0;           ///< positions of the sun
    double seconds = 0;         ///< by the engine of the settings
    double raySeconds = 0;      ///< by the ray reference
    double quickerSeconds = 0;  ///< by the automatic engine
    QString engine;             ///< in words; the automatic choice is resolved
    [[nodiscard]] double rays() const { return receivers * steps; }
};

/// A run expected to take at least this many seconds is announced before it starts.
constexpr double longRunSeconds = 600;

/// Uses the receivers and steps of the study: takes about 0.1 s, or a second for a year in steps of a minute.
/// Error: the study's own refusal, or stopped.
Result<RunEstimate> estimateRun(const City& city, const StudySettings& settings, const std::stop_token& stop);

/// The same for a study at points, by measuring some of them: see forecastElementStudy().
Result<RunEstimate> estimateRun(const City& city, const StudySettings& settings,
                                const ElementSettings& elements, Progress& progress,
                                const std::stop_token& stop);

/// The sun by place: of one city, or of a baseline and its scenarios.
struct PlacesRun {
    std::vector<std::shared_ptr<const City>> cities;
    std::vector<Place> places;
    SunByPlaceSettings settings;
    bool operator==(const PlacesRun&) const = default;
};
/// The same for the sun by place: see forecastSunByPlace(). The times of other engines are not estimated: 0.
Result<RunEstimate> estimateRun(const PlacesRun& run, const std::stop_token& stop);

/// Whether the settings' engine measures points (runElementStudy).
bool measuresPoints(const StudySettings& settings);

/// Whether a run can be long enough to be worth an estimate before it starts: any by rays, and large ones by
/// other engines. Without receivers or sun, so it takes no time.
bool mayBeLong(const StudySettings& settings);

/// "about 40 s", "about 3 h", "about 12 days".
QString describeAbout(double seconds);

/// "1.6 million cells, 540 positions of the sun. Horizon sweep: about 50 s. Rays would take about 9 h."
QString describe(const RunEstimate& estimate);

/// How long the study would take, computed in the background once its settings rest for a moment.
class RunForecast final : public QObject {
    Q_OBJECT
public:
    explicit RunForecast(QObject* parent = nullptr);

    void setCity(std::shared_ptr<const City> city);  ///< null: no forecast
    /// `elements`: points are measured instead of cells.
    void setSettings(const StudySettings& settings, const std::optional<ElementSettings>& elements = {});
    void setPlaces(PlacesRun run);  ///< in place of those settings and the city

    /// Nothing while it is being computed, without a city, or where the study would be refused.
    [[nodiscard]] const std::optional<RunEstimate>& estimate() const { return estimate_; }
    [[nodiscard]] const QString& refusal() const { return refusal_; }  ///< why the study cannot run; or empty

Q_SIGNALS:
    void changed();

private:
    void askSoon();
    void ask();

    QTimer* rest_;
    std::shared_ptr<const City> city_;
    StudySettings settings_;
    std::optional<ElementSettings> elements_;
    std::optional<PlacesRun> places_;
    std::optional<RunEstimate> estimate_;
    QString refusal_;
    JobSlot slot_;
};

}  // namespace noonmark
