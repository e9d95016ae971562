#include "app/window/review/windows/window_form.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>

#include "app/window/files/file_dialogs.h"
#include "app/window/widgets/number_fields.h"
#include "core/receivers/point_receivers.h"

namespace noonmark {

namespace {

QWidget* rowOf(QWidget* field, QWidget* button) {
    auto* content = new QWidget;
    auto* row = new QHBoxLayout(content);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(field, 1);
    row->addWidget(button);
    return content;
}

constexpr double leastM = FacadeSettings::leastM, mostM = FacadeSettings::mostM;
constexpr int facadesRow = 0, fileRow = 1;

}  // namespace

WindowForm::WindowForm(QWidget* parent)
    : QWidget(parent),
      form_(new QFormLayout(this)),
      source_(new QComboBox),
      file_(new QLineEdit),
      buildings_(new QLineEdit),
      addSelected_(new QPushButton(tr("Selected"))),
      bay_(numberField(leastM, mostM, 2, 0.5, tr(" m"))),
      storey_(numberField(leastM, mostM, 2, 0.1, tr(" m"))) {
    source_->setObjectName(QStringLiteral("windowSource"));
    source_->addItem(tr("Facades, bay by bay"));
    source_->addItem(tr("From a file"));
    source_->setToolTip(tr("A file of points or polygons with heights gives the real windows"));
    source_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    file_->setObjectName(QStringLiteral("windowFile"));
    file_->setPlaceholderText(tr("GeoPackage, GeoJSON, Shapefile..."));
    file_->setToolTip(tr("The file of the windows: points or polygons with heights"));
    buildings_->setObjectName(QStringLiteral("windowBuildings"));
    buildings_->setPlaceholderText(tr("All buildings"));
    buildings_->setToolTip(tr("Names or ids of buildings, with commas between them; empty: all buildings"));
    bay_->setToolTip(tr("Width of a bay, which has one window in each storey"));
    storey_->setToolTip(tr("Height of a storey; windows are numbered by it"));
    auto* browse = new QPushButton(tr("Browse..."));
    browse->setToolTip(file_->toolTip());
    fileRow_ = rowOf(file_, browse);
    buildingsRow_ = rowOf(buildings_, addSelected_);
    addSelected_->setObjectName(QStringLiteral("addSelectedBuilding"));
    addSelected_->setToolTip(tr("Adds the building that is selected in the view"));
    form_->setContentsMargins(0, 0, 0, 0);
    form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form_->addRow(tr("Windows"), source_);
    form_->addRow(tr("File"), fileRow_);
    form_->addRow(tr("Buildings"), buildingsRow_);
    form_->addRow(tr("Bay"), bay_);
    form_->addRow(tr("Storey"), storey_);
    connect(source_, &QComboBox::activated, this, &WindowForm::take);
    connect(browse, &QPushButton::clicked, this, &WindowForm::chooseFile);
    connect(addSelected_, &QPushButton::clicked, this, &WindowForm::addSelected);
    for (QLineEdit* field : {file_, buildings_})
        connect(field, &QLineEdit::editingFinished, this, &WindowForm::take);
    for (QDoubleSpinBox* field : {bay_, storey_})
        connect(field, &QDoubleSpinBox::valueChanged, this, &WindowForm::take);
    setSelected({});
    showSource();
}

void WindowForm::setSelected(const QString& id) {
    selected_ = id;
    addSelected_->setEnabled(!id.isEmpty());
}

void WindowForm::addSelected() {
    const QStringList named = buildings_->text().split(u',', Qt::SkipEmptyParts);
    if (named.contains(selected_)) return;
    buildings_->setText((named + QStringList{selected_}).join(u','));
    take();
}

void WindowForm::show(const WindowChoice& choice) {
    const QSignalBlocker quietBay(bay_), quietStorey(storey_);
    source_->setCurrentIndex(choice.ofFile ? fileRow : facadesRow);
    if (!file_->hasFocus()) file_->setText(QString::fromStdString(choice.file));
    if (!buildings_->hasFocus()) buildings_->setText(QString::fromStdString(choice.buildings));
    bay_->setValue(choice.bayM);
    storey_->setValue(choice.storeyM);
    showSource();
}

void WindowForm::showSource() {
    const bool ofFile = source_->currentIndex() == fileRow;
    form_->setRowVisible(fileRow_, ofFile);
    form_->setRowVisible(buildingsRow_, !ofFile);
    form_->setRowVisible(bay_, !ofFile);
}

void WindowForm::chooseFile() {
    const QString file = askForWindows(this);
    if (file.isEmpty()) return;
    file_->setText(file);
    take();
}

void WindowForm::take() {
    showSource();
    Q_EMIT edited({.ofFile = source_->currentIndex() == fileRow,
                   .file = file_->text().trimmed().toStdString(),
                   .buildings = buildings_->text().trimmed().toStdString(),
                   .bayM = bay_->value(),
                   .storeyM = storey_->value()});
}

}  // namespace noonmark
