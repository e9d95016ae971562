#include "app/gui/docks/project/saved_views.h"

#include <QMenu>
#include <algorithm>
#include <cmath>

#include "app/gui/base/widgets/buttons.h"
#include "app/gui/docks/project/project_dock.h"
#include "app/gui/session/project/project_changes.h"
#include "app/gui/session/project/project_session.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/time/time_strip.h"

namespace noonmark {

SavedView makeSavedView(const std::string& name, const CameraPose& pose, const ShownTime& look,
                        const std::optional<SectionBox>& section) {
    const double headingDeg = pose.headingDeg - 360 * std::floor(pose.headingDeg / 360);
    SavedView view{name,
                   pose.target,
                   pose.distanceM,
                   headingDeg,
                   std::clamp(pose.pitchDeg, 0.0, 90.0),
                   pose.isParallel()};
    if (look.span == ShownSpan::moment) view.moment = ViewMoment{look.date, look.at};
    if (section) view.section = ViewBox{section->lowM, section->highM};
    return view;
}

std::optional<SectionBox> sectionOf(const SavedView& view) {
    if (!view.section) return std::nullopt;
    return repairSection({view.section->lowM, view.section->highM});
}

CameraPose poseOf(const SavedView& view) {
    return {view.targetM, view.distanceM, view.headingDeg, view.pitchDeg,
            view.parallel ? Projection::parallel : Projection::perspective};
}

SavedViews::SavedViews(ProjectSession& session, ViewPanel& panel, ProjectDock& tree, QWidget& window)
    : session_(session),
      panel_(panel),
      tree_(tree),
      menu_(new QMenu(tr("Sa&ved views"), &window)),
      save_(makeAction(this, tr("&Save this view"), QKeySequence(tr("Ctrl+Shift+V")),
                       tr("Camera, projection, section box, and date and time if a moment is shown, under a "
                          "name in the project"))) {
    menu_->addAction(save_);
    connect(save_, &QAction::triggered, this, &SavedViews::save);
    connect(menu_, &QMenu::aboutToShow, this, &SavedViews::fillMenu);
    connect(&tree_, &ProjectDock::viewChosen, this, &SavedViews::show);
    connect(&tree_, &ProjectDock::saveViewRequested, this, &SavedViews::save);
}

void SavedViews::fillMenu() {
    menu_->clear();
    menu_->addAction(save_);
    menu_->addSeparator();
    for (const SavedView& view : session_.project().views) {
        QString text = QString::fromStdString(view.name);
        text.replace(QLatin1Char('&'), QStringLiteral("&&"));
        menu_->addAction(text, this, [this, name = view.name] { show(name); });
    }
    if (session_.project().views.empty()) menu_->addAction(tr("No view is saved yet"))->setEnabled(false);
}

void SavedViews::save() {
    Project next = session_.project();
    const std::string name = freeName(next, ProjectPart::view, tr("View").toStdString());
    next.views.push_back(
        makeSavedView(name, panel_.view().pose(), panel_.time().look(), panel_.section().box()));
    if (!session_.change(std::move(next), tr("save view %1").arg(QString::fromStdString(name)))) return;
    panel_.messages().showNote(tr("Saved as '%1' in the project. F2 in the project's list renames it.")
                                   .arg(QString::fromStdString(name)));
    tree_.select(ProjectPart::view, name);
}

void SavedViews::show(const std::string& name) {
    for (const SavedView& view : session_.project().views) {
        if (view.name != name) continue;
        panel_.navigator().go(poseOf(view));
        panel_.section().set(sectionOf(view));
        if (view.moment) panel_.time().choose({ShownSpan::moment, view.moment->date, view.moment->at});
        return;
    }
}

}  // namespace noonmark
