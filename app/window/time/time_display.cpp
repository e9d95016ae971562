#include "app/window/time/time_display.h"

#include "app/report/sheets/study_words.h"
#include "app/window/frame/workbench.h"
#include "app/window/time/time_strip.h"
#include "app/window/view/mode_switch.h"
#include "app/window/view/view_panel.h"

namespace noonmark {

namespace {

QString describeShare(const ShadowField& field) {
    const ShadowStatistics figures = computeStatistics(field);
    const double share = figures.receiverAreaM2 > 0 ? figures.shadowAreaM2 / figures.receiverAreaM2 : 0;
    return QObject::tr("%1 % in shadow").arg(describeAmount(100 * share));
}

}  // namespace

TimeDisplay::TimeDisplay(Workbench& workbench, const ModeSwitch& mode, ViewPanel& panel,
                         std::shared_ptr<SharedHorizonCache> horizons)
    : workbench_(workbench), mode_(mode), panel_(panel), looking_(std::move(horizons)) {
    TimeStrip& strip = panel_.time();
    for (auto signal :
         {&Workbench::studyDone, &Workbench::comparisonDone, &Workbench::scoreDone, &Workbench::savedShown})
        connect(&workbench_, signal, this, &TimeDisplay::offer);
    connect(&workbench_.session(), &ProjectSession::baselineChanged, this, &TimeDisplay::offer);
    connect(&mode_, &ModeSwitch::changed, this, &TimeDisplay::offer);
    connect(&strip, &TimeStrip::lookChanged, &looking_, &TimeLooking::look);
    connect(&strip, &TimeStrip::taken, this, &TimeDisplay::study);
    connect(&looking_, &TimeLooking::changed, this, &TimeDisplay::show);
    connect(&looking_, &TimeLooking::failed, &strip, [&strip](const TimeLook& look, const Error& error) {
        strip.setAnswer(look, QString::fromStdString(error.what));
    });
}

void TimeDisplay::offer() {
    const bool other = workbench_.comparison() || workbench_.score() || workbench_.saved();
    const bool shown = mode_.mode() != ViewMode::exploration && !other;
    const auto study = shown ? workbench_.study() : nullptr;
    TimeStrip& strip = panel_.time();
    if (study) strip.setPeriod(study->settings.period);
    strip.setVisible(study != nullptr);
    looking_.look(strip.look());
    looking_.setStudy(study);
}

void TimeDisplay::show() {
    const auto answer = looking_.answer();
    panel_.results().setTime(answer);
    if (answer) panel_.time().setAnswer(answer->look, describeShare(answer->field));
}

void TimeDisplay::study(const TimeLook& look) {
    StudySettings settings = workbench_.document().settings();
    settings.period = periodOf(look, settings.period);
    panel_.time().setLook(firstLook(settings.period));
    looking_.look(panel_.time().look());
    workbench_.document().change(settings, tr("period"));
    workbench_.run();
}

}  // namespace noonmark
