#include "app/report/sheets/study_words.h"
#include "app/window/frame/main_window.h"
#include "app/window/time/time_strip.h"
#include "app/window/view/view_panel.h"

// The part of MainWindow that shows a day or a moment of the displayed study.
namespace noonmark {

namespace {

QString shareWords(const ShadowField& field) {
    const ShadowStatistics figures = computeStatistics(field);
    const double share = figures.receiverAreaM2 > 0 ? figures.shadowAreaM2 / figures.receiverAreaM2 : 0;
    return QObject::tr("%1 % in shadow").arg(describeAmount(100 * share));
}

}  // namespace

void MainWindow::connectTime() {
    TimeStrip& strip = panel_->time();
    for (auto signal :
         {&Workbench::studyDone, &Workbench::comparisonDone, &Workbench::scoreDone, &Workbench::savedShown})
        connect(&workbench_, signal, this, &MainWindow::offerTime);
    connect(&workbench_.session(), &ProjectSession::baselineChanged, this, &MainWindow::offerTime);
    connect(&mode_, &ModeSwitch::changed, this, &MainWindow::offerTime);
    connect(&strip, &TimeStrip::lookChanged, &looking_, &TimeLooking::look);
    connect(&strip, &TimeStrip::taken, this, &MainWindow::studyTime);
    connect(&looking_, &TimeLooking::changed, this, &MainWindow::showTime);
    connect(&looking_, &TimeLooking::failed, &strip, [&strip](const TimeLook& look, const Error& error) {
        strip.setAnswer(look, QString::fromStdString(error.what));
    });
}

// The time strip is available while the study of one scenario is displayed.
void MainWindow::offerTime() {
    const bool other = workbench_.comparison() || workbench_.score() || workbench_.saved();
    const bool shown = mode_.mode() != ViewMode::exploration && !other;
    const auto study = shown ? workbench_.study() : nullptr;
    TimeStrip& strip = panel_->time();
    if (study) strip.setPeriod(study->settings.period);
    strip.setVisible(study != nullptr);
    looking_.look(strip.look());
    looking_.setStudy(study);
}

void MainWindow::showTime() {
    const auto answer = looking_.answer();
    panel_->results().setTime(answer);
    if (answer) panel_->time().setAnswer(answer->look, shareWords(answer->field));
}

void MainWindow::studyTime(const TimeLook& look) {
    StudySettings settings = workbench_.document().settings();
    settings.period = periodOf(look, settings.period);
    panel_->time().setLook(firstLook(settings.period));
    looking_.look(panel_->time().look());
    workbench_.document().change(settings, tr("period"));
    workbench_.run();
}

}  // namespace noonmark
