#include "app/gui/frame/actions/height_colours.h"

#include <QAction>
#include <QLabel>

#include "app/gui/base/widgets/make_action.h"
#include "app/gui/base/widgets/number_words.h"
#include "app/gui/base/widgets/translated.h"
#include "app/gui/session/workbench.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/report/maps/height_source_colours.h"

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

}  // namespace noonmark
