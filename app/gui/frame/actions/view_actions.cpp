#include "app/gui/frame/actions/view_actions.h"

#include <QAction>
#include <QLabel>
#include <QSettings>

#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/docks/project/project_dock.h"
#include "app/gui/session/workbench.h"
#include "app/gui/tools/editing/edit_tools.h"
#include "app/gui/view/exploration/exploration.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/panel/view_tools.h"
#include "app/report/maps/answer_legends.h"
#include "render/view/traced_city.h"

namespace noonmark {

namespace {

std::vector<OverlayBodies::Coloured> groupBySource(const City& city) {
    std::vector<OverlayBodies::Coloured> groups(heightSources.size());
    for (const HeightSourceColour& one : heightSourceColours())
        groups[std::size_t(one.source)].colour = {one.colour.redF(), one.colour.greenF(), one.colour.blueF()};
    for (const auto& building : city.buildings)
        groups[std::size_t(sourceOfHeight(*building))].some.buildings.push_back(building);
    for (OverlayBodies::Coloured& group : groups) {
        group.some.frame = city.frame;
        group.some.terrain = city.terrain;
    }
    return groups;
}

// "[blue] measured 163   [yellow] from storeys 594"
QString describeLegend(const SourceCounts& counts) {
    QString text = QObject::tr("Heights of buildings:");
    for (const HeightSourceColour& one : heightSourceColours())
        if (const std::size_t count = counts[std::size_t(one.source)]; count > 0)
            text += QStringLiteral(" &nbsp; <span style=\"color:%1\">\u25a0</span> %2 %3")
                        .arg(one.colour.name(), translated(one.label).toHtmlEscaped(), formatCount(count));
    return text;
}

std::vector<LegendPatch> translatedPatches(const SourceCounts& counts) {
    std::vector<LegendPatch> patches = sourcePatches(counts);
    for (LegendPatch& patch : patches)
        patch.label = QObject::tr("height %1").arg(translated(patch.label.toStdString()));
    return patches;
}

}  // namespace

HeightColours::HeightColours(Workbench& workbench, ViewPanel& panel)
    : workbench_(workbench),
      panel_(panel),
      action_(makeAction(this, tr("Colour &by source of height"), {},
                         tr("Buildings whose height is measured, computed from storeys or assumed"))),
      legend_(new QLabel) {
    action_->setObjectName(QStringLiteral("colourByHeightSource"));
    action_->setCheckable(true);
    legend_->setObjectName(QStringLiteral("heightSourceLegend"));
    legend_->setTextFormat(Qt::RichText);
    legend_->setContentsMargins(8, 2, 8, 2);
    legend_->setWordWrap(true);
    legend_->hide();
    panel_.addLegendRow(legend_);
    connect(action_, &QAction::toggled, this, &HeightColours::refresh);
    connect(&workbench_, &Workbench::cityShown, this, &HeightColours::refresh);
}

void HeightColours::refresh() {
    const bool shown = action_->isChecked() && workbench_.city();
    const SourceCounts counts = shown ? countSources(workbench_.city()->city()) : SourceCounts{};
    panel_.view().overlay().showColoured(
        shown ? groupBySource(workbench_.city()->city()) : std::vector<OverlayBodies::Coloured>(),
        OverlayBodies::ColouredBy::heightSource);
    legend_->setText(describeLegend(counts));
    legend_->setVisible(shown);
    panel_.setBuildingPatches(translatedPatches(counts));
}

namespace {

const QString storeyLinesKey = QStringLiteral("storeyLines");
const QString liveChangeKey = QStringLiteral("liveChange");

}  // namespace

TowerDisplay::TowerDisplay(QSettings& settings, EditTools& tools)
    : settings_(settings),
      tools_(tools),
      storeyLines_(makeAction(this, tr("Store&y lines"), {},
                              tr("Lines at the floors of proposed towers, and of imported buildings whose "
                                 "storey height is known"))),
      aboveDatum_(makeAction(this, tr("&Heights above datum"), {},
                             tr("Heights of buildings above the vertical zero of the project's terrain "
                                "instead of above the ground under each building, as shown and as typed"))) {
    for (QAction* one : {storeyLines_, aboveDatum_}) one->setCheckable(true);
    storeyLines_->setChecked(settings_.value(storeyLinesKey, true).toBool());
    aboveDatum_->setChecked(readHeightReference(settings_) == HeightReference::datum);
    connect(storeyLines_, &QAction::toggled, this, &TowerDisplay::setStoreyLines);
    connect(aboveDatum_, &QAction::toggled, this, &TowerDisplay::setAboveDatum);
    tools_.changeAction().setChecked(settings_.value(liveChangeKey, true).toBool());
    connect(&tools_.changeAction(), &QAction::toggled, this,
            [this](bool on) { settings_.setValue(liveChangeKey, on); });
    tools_.setStoreyLines(storeyLines_->isChecked());
    applyHeightReference(readHeightReference(settings_));
    tools_.heightReferenceChanged();
}

void TowerDisplay::setStoreyLines(bool on) {
    settings_.setValue(storeyLinesKey, on);
    tools_.setStoreyLines(on);
}

void TowerDisplay::setAboveDatum(bool on) {
    const HeightReference reference = on ? HeightReference::datum : HeightReference::ground;
    saveHeightReference(reference, settings_);
    applyHeightReference(reference);
    tools_.heightReferenceChanged();
}

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
      trees_(
          makeSwitch(this, tr("Trees"), {}, tr("The trees of the city, bare on days without leaves"), true)),
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
    connect(trees_, &QAction::toggled, &panel_.view(), &CityView::setTreesVisible);
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
