#include "app/gui/view/panel/mode_switch.h"

#include <QAction>
#include <QActionGroup>

#include "app/gui/base/looks/icons.h"
#include "app/gui/session/study/study_document.h"

namespace noonmark {

namespace {

const std::string rays = "ray";

}  // namespace

ModeSwitch::ModeSwitch(StudyDocument& document, QObject* parent)
    : QObject(parent), document_(document), group_(new QActionGroup(this)) {
    makeAction(ViewMode::exploration, Qt::Key_F5);
    makeAction(ViewMode::analysis, Qt::Key_F6);
    makeAction(ViewMode::rayReference, Qt::Key_F7);
    actions()[int(mode_)]->setChecked(true);
    connect(&document_, &StudyDocument::changed, this, &ModeSwitch::followDocument);
    followDocument();
}

void ModeSwitch::makeAction(ViewMode mode, const QKeySequence& keys) {
    QAction* action = group_->addAction(nameOf(mode));
    action->setObjectName(QStringLiteral("mode%1").arg(int(mode)));
    const char* const icons[] = {"explore", "analyse", "reference"};
    action->setIcon(makeIcon(QString::fromLatin1(icons[int(mode)])));
    action->setCheckable(true);
    action->setShortcut(keys);
    action->setToolTip(
        QStringLiteral("%1 (%2)").arg(describeMeasure(mode), keys.toString(QKeySequence::NativeText)));
    action->setStatusTip(describeMeasure(mode).replace(QLatin1Char('\n'), QLatin1Char(' ')));
    connect(action, &QAction::triggered, this, [this, mode] { setMode(mode); });
}

QList<QAction*> ModeSwitch::actions() const { return group_->actions(); }

void ModeSwitch::setMode(ViewMode mode) {
    enter(mode);
    const std::string engine = document_.settings().engine;
    if (mode == ViewMode::rayReference) takeEngine(rays);
    if (mode == ViewMode::analysis && engine == rays && !analysisEngine_.empty()) takeEngine(analysisEngine_);
}

void ModeSwitch::showStudies() {
    if (mode_ == ViewMode::exploration)
        enter(document_.settings().engine == rays ? ViewMode::rayReference : ViewMode::analysis);
}

void ModeSwitch::enter(ViewMode mode) {
    actions()[int(mode)]->setChecked(true);
    if (mode == mode_) return;
    mode_ = mode;
    Q_EMIT changed(mode);
}

void ModeSwitch::takeEngine(const std::string& engine) {
    StudySettings settings = document_.settings();
    settings.engine = engine;
    settings.engineSettings.clear();
    document_.change(settings, tr("engine"));
}

void ModeSwitch::followDocument() {
    const std::string& engine = document_.settings().engine;
    if (engine != rays) analysisEngine_ = engine;
    if (mode_ == ViewMode::exploration) return;
    if (engine != rays) enter(ViewMode::analysis);
    if (engine == rays && analysisEngine_ != rays) enter(ViewMode::rayReference);
}

}  // namespace noonmark
