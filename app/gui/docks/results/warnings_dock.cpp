#include "app/gui/docks/results/warnings_dock.h"

#include <algorithm>

#include "app/gui/base/widgets/error_words.h"

namespace noonmark {

namespace {

// Limits the rows per kind; study.json lists all.
constexpr std::size_t maxPlaces = 2000;

QTreeWidgetItem* itemOf(const WarningGroup& group) {
    auto* item = new QTreeWidgetItem({describeWarning(group)});
    item->setToolTip(0, item->text(0));
    const std::size_t shown = std::min(group.where.size(), maxPlaces);
    for (std::size_t i = 0; i < shown; ++i)
        item->addChild(new QTreeWidgetItem({QString::fromStdString(group.where[i])}));
    if (shown < group.where.size())
        item->addChild(new QTreeWidgetItem(
            {QObject::tr("and %1 more, listed in study.json of an export").arg(group.where.size() - shown)}));
    return item;
}

}  // namespace

WarningsDock::WarningsDock(QWidget* parent) : QTreeWidget(parent) {
    setHeaderHidden(true);
    setFrameShape(QFrame::NoFrame);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setToolTip(tr("Double-click a feature or press Enter to go to its building"));
    connect(this, &QTreeWidget::itemActivated, this, [this](const QTreeWidgetItem* item) {
        if (item->parent()) Q_EMIT placeChosen(item->text(0));
    });
    show({});
}

void WarningsDock::show(const Warnings& warnings) {
    clear();
    for (const WarningGroup& group : groupWarnings(warnings)) addTopLevelItem(itemOf(group));
    if (warnings.empty())
        addTopLevelItem(new QTreeWidgetItem({tr("No warnings: nothing was left out, repaired or assumed")}));
}

}  // namespace noonmark
