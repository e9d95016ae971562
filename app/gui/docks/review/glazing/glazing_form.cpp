#include "app/gui/docks/review/glazing/glazing_form.h"

#include <QComboBox>
#include <QFormLayout>
#include <QVBoxLayout>

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

}  // namespace noonmark
