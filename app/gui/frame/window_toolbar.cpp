#include "app/gui/frame/window_toolbar.h"

#include <QToolBar>

#include "app/gui/frame/actions/edit_actions.h"
#include "app/gui/frame/actions/opening_actions.h"
#include "app/gui/frame/actions/place_actions.h"
#include "app/gui/frame/actions/region_actions.h"
#include "app/gui/frame/actions/result_actions.h"
#include "app/gui/frame/actions/saving_actions.h"
#include "app/gui/frame/actions/study_actions.h"
#include "app/gui/frame/actions/view_actions.h"
#include "app/gui/frame/window_menus.h"

namespace noonmark {

namespace {

// A tool button states its key; menus do so by themselves.
void addTool(QToolBar& bar, QAction* action) {
    const QString tip = action->toolTip().isEmpty() ? action->iconText() : action->toolTip();
    const QString keys = action->shortcut().toString(QKeySequence::NativeText);
    if (!keys.isEmpty() && !tip.contains(keys)) action->setToolTip(QStringLiteral("%1 (%2)").arg(tip, keys));
    bar.addAction(action);
}

}  // namespace

void fillToolBar(QToolBar& bar, const WindowActions& actions) {
    bar.setToolButtonStyle(Qt::ToolButtonIconOnly);
    const QList<QList<QAction*>> groups{
        {actions.opening.openAction(), actions.saving.actions().first()},
        actions.edits.undoActions(),
        {actions.study.runActions().first(), actions.region.actions().first(),
         actions.edits.toolActions().first()},
        {actions.view.cameraActions().first(), actions.results.fileActions().last()}};
    for (const QList<QAction*>& group : groups) {
        if (!bar.actions().isEmpty()) bar.addSeparator();
        for (QAction* action : group) addTool(bar, action);
    }
}

}  // namespace noonmark
