#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>

#include "app/gui/base/jobs/job.h"
#include "app/gui/view/time/moment_preview.h"
#include "core/engines/depths/sun_depth_map.h"
#include "core/sun/solar_position.h"

namespace noonmark {

/// What the shadow of one moment is drawn for.
struct SunView {
    glm::dvec3 towardsSun{0, 0, 1};  ///< above the horizon
    LitSpace space;
    int size = 1024;  ///< texels a side of the map
    int treeDay = 0;  ///< day of the year whose leaves trees have; 0: trees cast no shade
};

struct MomentCasters;

/// Draws the map of a moment's shadow in jobs, one at a time; of the views that arrive meanwhile the newest
/// is next. The faces of the city and its crowns are prepared once.
class SunShadow final : public QObject {
    Q_OBJECT
public:
    explicit SunShadow(QObject* parent = nullptr) : QObject(parent) {}

    void setCity(std::shared_ptr<const City> city);
    void look(const std::optional<SunView>& view);  ///< none: no map

    /// The depth map of the newest view that is drawn; null: none, or none yet.
    [[nodiscard]] std::shared_ptr<const SunDepthMap> map() const { return map_; }
    [[nodiscard]] bool busy() const { return slot_.busy(); }
    [[nodiscard]] const std::optional<SunView>& view() const { return view_; }  ///< of look()

Q_SIGNALS:
    void changed();

private:
    struct Drawn {
        std::shared_ptr<const MomentCasters> casters;
        std::shared_ptr<const SunDepthMap> map;
    };
    void ask();
    void take(const Result<Drawn>& drawn);

    std::shared_ptr<const City> city_;
    std::shared_ptr<const MomentCasters> casters_;  // of city_; null: not prepared yet
    std::optional<SunView> view_;
    bool waiting_ = false;  // view_ has changed since the running job began
    std::shared_ptr<const SunDepthMap> map_;
    JobSlot slot_;
};

inline constexpr int minutesOfDay = 24 * 60;  ///< of the wall clock

/// The sun at a shown date and time, whatever the span, and sunrise and sunset of that date.
struct SunAtMoment {
    glm::dvec3 towards{0, 0, 1};  ///< unit vector in the frame of the geometry
    double azimuthDeg = 0;        ///< from true north, clockwise
    double altitudeDeg = 0;       ///< below 0 at night
    /// Wall clock, minutes since midnight, upper limb; none on polar days and nights.
    std::optional<int> sunriseMin, sunsetMin;
    [[nodiscard]] bool isUp() const { return altitudeDeg > 0; }
};

/// Zone and refraction are those of `period`. Error: an unknown zone. About 0.3 ms.
Result<SunAtMoment> computeSunAt(const Observer& observer, const Period& period, const ShownTime& look);

/// The present as a shown time.
struct PresentTime {
    ShownTime look;
    bool isNoon = false;  ///< noon of that day instead: the sun is down or low
};

/// The moment that it is at `now` in the period's zone, with the day in the year of the period; noon of that
/// day while the sun is down or less than 10 degrees high and higher at noon: then nearly all ground is dark.
/// Error: an unknown zone.
Result<PresentTime> findPresentTime(const Observer& observer, const Period& period, Instant now);

/// "Sun 221° SW, 32° high", "Sun below the horizon".
QString describe(const SunAtMoment& sun);

/// "06:58".
QString describeClock(int minutes);

/// What play repeats.
enum class SunLoop { day, year };

/// The shown time a little later, when the sun is played: over the day's light, or over the dates of the year
/// at the same time of day. Wraps around. `speed`: hours of the day or weeks of the year in a second.
ShownTime advance(const ShownTime& look, const SunAtMoment& sun, SunLoop loop, double seconds, double speed);

/// The shown time moved by minutes and days, within its year and its day.
ShownTime nudge(ShownTime look, int minutes, int days);

}  // namespace noonmark
