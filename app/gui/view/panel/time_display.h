#pragma once

#include <QObject>
#include <QPointF>
#include <functional>
#include <optional>

#include "app/gui/view/time/moment_preview.h"
#include "app/gui/view/time/sun_at_moment.h"

class QAction;
class QTimer;

namespace noonmark {

class ModeSwitch;
class ViewPanel;
class Workbench;

/// Connects the time strip with the view. At one moment it shows sun and shadow on everything; for the study
/// of one scenario also its day or moment, with figures, and a study of just that time runs on request.
class TimeDisplay final : public QObject {
    Q_OBJECT
public:
    /// `horizons` may be shared. All must outlive this object.
    TimeDisplay(Workbench& workbench, const ModeSwitch& mode, ViewPanel& panel,
                std::shared_ptr<SharedHorizonCache> horizons);

    /// The current time: the system's clock unless set.
    using Clock = std::function<Instant()>;
    void setClock(Clock clock) { clock_ = std::move(clock); }
    /// Shows sun and shadow of the present moment at the city, or of noon while it is night there. It lasts
    /// until another moment is chosen or exploration ends: then the whole period is shown.
    void showPresent();
    /// Shows another sun than that of the strip, until showStripSun(); `then` is called when its shadows are
    /// drawn. The strip must show a moment.
    void showSunFrom(const glm::dvec3& towards, std::function<void()> then);
    void showStripSun() { showSun(); }
    /// While an edit is shaped the view shows what it changes in the study's period, and so does the strip;
    /// then the moment of before returns.
    void setDesigning(bool designing);
    void offer();  ///< after another city, period or result is shown
    [[nodiscard]] bool showsMoment() const;
    /// "21 June 2026, 12:00. Sun 180° S, 72° high", and whether it stands for the night; empty: no moment is
    /// shown.
    [[nodiscard]] QString moment() const;
    /// The moment that was chosen, to be saved: "2026-12-21 12:30"; empty: none, or the present.
    [[nodiscard]] std::string choice() const;
    bool restore(const std::string& choice);  ///< false where it is not valid
    [[nodiscard]] MomentPreview& moments() { return moments_; }
    [[nodiscard]] const MomentPreview& moments() const { return moments_; }
    [[nodiscard]] const SunShadow& shadow() const { return shadow_; }
    [[nodiscard]] const SunAtMoment& sun() const { return sun_; }  ///< at the date and time of the strip
    /// Another city whose shadows the view shows beside those of the displayed one; null: none.
    void setOtherCity(std::shared_ptr<const City> city);
    /// Plays and moves the sun, for a menu.
    [[nodiscard]] const QList<QAction*>& actions() const { return actions_; }

Q_SIGNALS:
    void momentChanged();  ///< showsMoment() may have changed
    void sunChanged();     ///< sun(), or what it was computed for

private:
    void connectWorkbench();
    void connectView();
    void makeActions();
    void look(const ShownTime& look);
    void leavePresent();
    void showPeriod();
    [[nodiscard]] ShownTime inPeriod(ShownTime look) const;
    void followPeriod();
    void freeLabel();
    [[nodiscard]] bool showsPresent() const;
    void show();
    void showSun();
    void drawShadow();
    void followCamera();
    void awaitShadow(const std::function<void()>& then);
    void lookFrom(const std::optional<SunView>& view);
    [[nodiscard]] LitSpace seenSpace() const;
    void turnSun(QPointF byPx);
    void study(const ShownTime& look);

    Workbench& workbench_;
    const ModeSwitch& mode_;
    ViewPanel& panel_;
    MomentPreview moments_;
    SunShadow shadow_;
    SunShadow otherShadow_;  // of CityView::other()
    bool otherShown_ = false;
    SunAtMoment sun_;
    Clock clock_ = [] {
        return std::chrono::time_point_cast<Instant::duration>(std::chrono::system_clock::now());
    };
    std::optional<PresentTime> present_;  ///< of showPresent()
    struct Before {
        ShownTime look;
        std::optional<PresentTime> present;
    };
    std::optional<Before> beforeDesign_;
    std::optional<std::pair<CivilDate, int>> days_;  ///< first day and days of the document's period
    QTimer* rest_;                                   // then the shadow is drawn finely
    QPointF turned_;                                 // minutes and days of a drag that are not whole yet
    QList<QAction*> actions_;
};

}  // namespace noonmark
