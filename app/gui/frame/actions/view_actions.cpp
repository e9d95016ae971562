#include "app/gui/frame/actions/view_actions.h"

#include "app/gui/base/widgets/make_action.h"
#include "app/gui/docks/project/project_dock.h"
#include "app/gui/frame/actions/height_colours.h"
#include "app/gui/session/workbench.h"
#include "app/gui/view/exploration/exploration.h"
#include "app/gui/view/panel/section_dialog.h"
#include "app/gui/view/panel/view_panel.h"
#include "render/view/software_drawing.h"

namespace noonmark {

namespace {

constexpr QPoint cornerOfView{12, 60};  // where a small window covers little of the view

QAction* makeSwitch(QObject* owner, const QString& text, const QKeySequence& keys, const QString& tip,
                    bool on) {
    QAction* action = makeAction(owner, text, keys, tip);
    action->setCheckable(true);
    action->setChecked(on);
    return action;
}

}  // namespace

ViewActions::ViewActions(Workbench& workbench, ViewPanel& panel, Exploration& exploration, ProjectDock& tree)
    : workbench_(workbench),
      panel_(panel),
      wholeCity_(makeAction(this, tr("Zoom to whole &city"), Qt::Key_Home, {}, "whole-city")),
      northUp_(makeAction(this, tr("&North up"), Qt::Key_N, {}, "north")),
      fromAbove_(makeAction(this, tr("&Top view"), Qt::Key_T, {}, "top-view")),
      region_(makeAction(this, tr("Zoom to &region"), Qt::Key_R, tr("The study region seen from above"),
                         "region")),
      faces_(makeSwitch(this, tr("&Solid buildings"), Qt::Key_B,
                        tr("Off: wireframe, so that the ground behind buildings is visible"), true)),
      map_(makeSwitch(this, tr("&Map on the ground"), Qt::Key_G,
                      tr("Streets, paths, parks, water and trees, drawn for orientation"), true)),
      byMaps_(makeSwitch(this, tr("&Explore by shadow accrual maps"), {},
                         tr("As in the paper, instead of rays: inexact at shadow edges, but hours that "
                            "look alike are computed once"),
                         !drawsInSoftware())),
      measure_(
          makeSwitch(this, tr("Me&asure distances"), QKeySequence(tr("Shift+M")),
                     tr("Click points on roofs, walls and ground: distance, height, area. Backspace removes "
                        "the last point, a double click ends"),
                     false)),
      section_(
          makeSwitch(this, tr("Section bo&x"), QKeySequence(tr("Shift+X")),
                     tr("Cuts away what lies outside a box, by handles or numbers; shadows remain those of "
                        "the whole city"),
                     false)),
      heights_(new HeightColours(workbench, panel)) {
    heights_->setParent(this);
    ViewNavigator& navigator = panel_.navigator();
    connect(wholeCity_, &QAction::triggered, &navigator, &ViewNavigator::showWholeCity);
    connect(northUp_, &QAction::triggered, &navigator, &ViewNavigator::turnNorthUp);
    connect(fromAbove_, &QAction::triggered, &navigator, &ViewNavigator::lookFromAbove);
    connect(region_, &QAction::triggered, this, &ViewActions::showRegion);
    connect(faces_, &QAction::toggled, &panel_.view(), &CityView::showFaces);
    connect(map_, &QAction::toggled, &panel_.map(), &MapLayer::setShown);
    connect(byMaps_, &QAction::toggled, &exploration, &Exploration::setByMaps);
    exploration.setByMaps(byMaps_->isChecked());
    connect(measure_, &QAction::triggered, this, &ViewActions::setMeasuring);
    connect(&panel_.measureTool(), &MeasureTool::activeChanged, measure_, &QAction::setChecked);
    connect(section_, &QAction::triggered, this, &ViewActions::setSection);
    connect(&panel_.section(), &SectionTool::changed, section_,
            [this] { section_->setChecked(panel_.section().box().has_value()); });
    connect(&tree, &ProjectDock::lotChosen, this, [this](const NamedLot& lot) {
        panel_.navigator().showSlanting(boxAround({lot.name, {lot.outline}}));
    });
}

void ViewActions::setMeasuring(bool on) {
    panel_.setUnits(workbench_.session().project().sheets.units);
    on ? panel_.measureTool().begin() : panel_.measureTool().end();
}

void ViewActions::setSection(bool on) {
    if (!sectionDialog_) {
        sectionDialog_ = new SectionDialog(panel_, &panel_);
        sectionDialog_->move(panel_.mapToGlobal(cornerOfView));
        connect(sectionDialog_, &SectionDialog::removed, this, [this] { setSection(false); });
    }
    on ? panel_.section().setAroundCity() : panel_.section().set({});
    sectionDialog_->setVisible(on);
}

void ViewActions::showRegion() {
    const Box2 box = bounds(workbench_.document().settings().region);
    if (!box.empty()) panel_.navigator().show(box);
}

Box2 boxAround(const Region& region) {
    const Box2 box = bounds(region);
    const glm::vec2 border = (box.high - box.low) * 0.15F;
    return {box.low - border, box.high + border};
}

}  // namespace noonmark
