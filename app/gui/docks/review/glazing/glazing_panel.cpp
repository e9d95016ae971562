#include "app/gui/docks/review/glazing/glazing_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "app/gui/docks/review/glazing/glazing_table.h"
#include "app/gui/docks/study_form/element_form.h"

namespace noonmark {

GlazingForm::GlazingForm(QWidget* parent)
    : QWidget(parent), source_(new QComboBox), form_(new ElementForm(ElementForm::Use::rule)) {
    source_->setObjectName(QStringLiteral("windowSource"));
    source_->addItem(tr("Facades, bay by bay"), int(ElementPlaces::facades));
    source_->addItem(tr("From a file"), int(ElementPlaces::windows));
    source_->setToolTip(tr("A file of points or polygons with heights gives the real windows"));
    source_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    auto* row = new QFormLayout;
    row->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    row->addRow(tr("Windows"), source_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(row);
    column->addWidget(form_);
    column->addStretch();
    connect(source_, &QComboBox::activated, this, [this] {
        ElementSettings windows = form_->settings();
        windows.places = ElementPlaces(source_->currentData().toInt());
        form_->show(windows);
        Q_EMIT edited(windows);
    });
    connect(form_, &ElementForm::edited, this,
            [this](const ElementSettings& windows) { Q_EMIT edited(windows); });
}

void GlazingForm::show(const ElementSettings& windows) {
    source_->setCurrentIndex(source_->findData(int(windows.places)));
    form_->show(windows);
}

void GlazingForm::setBuilding(const QString& id) { form_->setBuilding(id); }

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
