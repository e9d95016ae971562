#include "app/gui/view/panel/mode_switch.h"

#include <QAction>
#include <QActionGroup>

#include "app/gui/base/looks/icons.h"

namespace noonmark {

ModeSwitch::ModeSwitch(QObject* parent) : QObject(parent), group_(new QActionGroup(this)) {
    makeAction(ViewMode::exploration, Qt::Key_F5);
    makeAction(ViewMode::analysis, Qt::Key_F6);
    makeAction(ViewMode::review, Qt::Key_F7);
    actions()[int(mode_)]->setChecked(true);
}

void ModeSwitch::makeAction(ViewMode mode, const QKeySequence& keys) {
    QAction* action = group_->addAction(nameOf(mode));
    action->setObjectName(QStringLiteral("mode%1").arg(int(mode)));
    const char* const icons[] = {"sun", "analyse", "review"};
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
    actions()[int(mode)]->setChecked(true);
    if (mode == mode_) return;
    mode_ = mode;
    Q_EMIT changed(mode);
}

void ModeSwitch::showStudies() {
    if (mode_ == ViewMode::exploration) setMode(ViewMode::analysis);
}

}  // namespace noonmark
