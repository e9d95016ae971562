#include "app/gui/docks/review/glazing/glazing_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "app/gui/docks/review/glazing/glazing_table.h"

namespace noonmark {

GlazingPanel::GlazingPanel(QWidget* parent)
    : QWidget(parent), choice_(new QComboBox), table_(new GlazingTable) {
    choice_->setObjectName(QStringLiteral("verdictsInView"));
    choice_->addItem(tr("Verdicts after"), int(ShownVerdicts::after));
    choice_->addItem(tr("Verdicts before"), int(ShownVerdicts::before));
    choice_->addItem(tr("Changed verdicts"), int(ShownVerdicts::change));
    choice_->addItem(tr("No verdicts"), int(ShownVerdicts::none));
    choice_->setToolTip(
        tr("What the 3D view shows on the walls: a tile for each window in the colour of its verdict.\n"
           "A click on a tile selects its row, a click on a row frames its window."));
    auto* label = new QLabel(tr("In the view"));
    label->setBuddy(choice_);
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(choice_);
    row->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(row);
    column->addWidget(table_, 1);
    connect(choice_, &QComboBox::activated, this, [this] {
        away_.reset();
        Q_EMIT shownChanged();
    });
}

ShownVerdicts GlazingPanel::shown() const { return ShownVerdicts(choice_->currentData().toInt()); }

void GlazingPanel::setShown(ShownVerdicts shown) {
    choice_->setCurrentIndex(choice_->findData(int(shown)));
    away_.reset();
    Q_EMIT shownChanged();
}

void GlazingPanel::putAway() {
    if (shown() == ShownVerdicts::none) return;
    const ShownVerdicts before = shown();
    setShown(ShownVerdicts::none);
    away_ = before;
}

void GlazingPanel::bringBack() {
    if (away_) setShown(*away_);
}

}  // namespace noonmark
