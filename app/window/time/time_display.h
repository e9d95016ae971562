#pragma once

#include <QObject>

#include "app/window/time/time_looking.h"

namespace noonmark {

class ModeSwitch;
class ViewPanel;
class Workbench;

/// Offers the time strip while the study of one scenario is displayed, and shows the day or moment chosen
/// there; a study of just that time runs on request.
class TimeDisplay final : public QObject {
    Q_OBJECT
public:
    /// `horizons` may be shared. All must outlive this object.
    TimeDisplay(Workbench& workbench, const ModeSwitch& mode, ViewPanel& panel,
                std::shared_ptr<SharedHorizonCache> horizons);

    void offer();  ///< shows or hides the strip for the displayed result
    [[nodiscard]] TimeLooking& looking() { return looking_; }
    [[nodiscard]] const TimeLooking& looking() const { return looking_; }

private:
    void show();
    void study(const TimeLook& look);

    Workbench& workbench_;
    const ModeSwitch& mode_;
    ViewPanel& panel_;
    TimeLooking looking_;
};

}  // namespace noonmark
