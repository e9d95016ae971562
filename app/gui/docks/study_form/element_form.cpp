#include "app/gui/docks/study_form/element_form.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <algorithm>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/field_rows.h"
#include "app/gui/docks/study_form/face_form.h"
#include "app/gui/docks/study_form/line_form.h"
#include "core/study/elements/element_fields.h"

namespace noonmark {

namespace {

QLineEdit* lineField(const char* name, const QString& placeholder, const QString& tip) {
    auto* field = new QLineEdit;
    field->setObjectName(QString::fromLatin1(name));
    field->setPlaceholderText(placeholder);
    field->setToolTip(tip);
    return field;
}

}  // namespace

ElementForm::ElementForm(Use use, QWidget* parent)
    : QWidget(parent),
      use_(use),
      form_(new QFormLayout(this)),
      rows_(new FieldRows(elementFields().rows(), this)) {
    makeFields();
    placeFields();
    connectFields();
    connectParts();
    show(settings_);
}

void ElementForm::makeFields() {
    connect(rows_, &FieldRows::edited, this, [this](const QString& label, const QString& flag) {
        rows_->take(elementFields().of(settings_), flag.toStdString());
        Q_EMIT edited(settings_, label);
    });
    proposed_ = new QCheckBox(tr("Proposed buildings only"));
    proposed_->setObjectName(QStringLiteral("proposedOnly"));
    proposed_->setToolTip(tr("The buildings that the displayed scenario builds or changes"));
    faces_ = new FaceForm;
    lines_ = new LineForm;
    list_ = new PointListForm;
}

QWidget* ElementForm::makeBuildings() {
    const bool isStudy = use_ == Use::study;
    buildings_ =
        lineField("facadesOf", isStudy ? tr("all of the region") : tr("all buildings"),
                  isStudy ? tr("Names or ids of buildings, with commas between them; their middle must be in "
                               "the region. Empty: all buildings of the region")
                          : tr("Names or ids of buildings, with commas between them. Empty: all buildings"));
    selected_ = pushButton({}, "facadesOfSelected",
                           tr("Adds the selected building, or removes it. Click a building first."));
    return widgetRow({buildings_, selected_}, 1);
}

QWidget* ElementForm::makeFile() {
    file_ = lineField("windowsFile", tr("file of windows"),
                      tr("Points or polygons with heights, in any vector format. Fields id, azimuth, floor"));
    browse_ = pushButton(tr("Browse..."), "browseWindows", tr("Chooses the file of windows"));
    return widgetRow({file_, browse_}, 1);
}

void ElementForm::placeFields() {
    form_->setContentsMargins(0, 0, 0, 0);
    form_->addRow(tr("Of"), makeBuildings());
    form_->addRow(QString(), proposed_);
    form_->addRow(tr("File"), makeFile());
    rows_->addRows(*form_, {"--window-heights", "--bay", "--storey", "--above-floor"});
    form_->addRow(lines_);
    rows_->addRows(*form_, {"--plane-height"});
    form_->addRow(faces_);
    form_->addRow(list_);
}

void ElementForm::connectParts() {
    connect(proposed_, &QCheckBox::clicked, this, [this](bool only) {
        settings_.proposed = only;
        showRows();
        Q_EMIT edited(settings_, tr("buildings"));
    });
    connect(faces_, &FaceForm::edited, this, [this](const FaceChoice& faces, const QString& field) {
        settings_.faces = faces;
        Q_EMIT edited(settings_, field);
    });
    connect(lines_, &LineForm::edited, this,
            [this](const std::string& parcel, const LineSettings& lines, const QString& field) {
                settings_.parcel = parcel;
                settings_.lines = lines;
                Q_EMIT edited(settings_, field);
            });
    connect(list_, &PointListForm::edited, this,
            [this](const std::vector<ListedPoint>& points, const QString& field) {
                settings_.points = points;
                Q_EMIT edited(settings_, field);
            });
}

void ElementForm::setNames(const QStringList& lots, const QStringList& places) {
    lines_->setLots(lots);
    faces_->setPlaces(places);
}

void ElementForm::connectFields() {
    connect(buildings_, &QLineEdit::editingFinished, this, [this] {
        const auto names = splitNames(buildings_->text());
        if (names == settings_.buildings) return;
        settings_.buildings = names;
        Q_EMIT edited(settings_, tr("buildings"));
    });
    connect(file_, &QLineEdit::editingFinished, this, [this] {
        if (file_->text().toStdString() == settings_.windows.string()) return;
        settings_.windows = file_->text().toStdString();
        Q_EMIT edited(settings_, tr("windows"));
    });
    connect(browse_, &QPushButton::clicked, this, &ElementForm::browse);
    connect(selected_, &QPushButton::clicked, this, &ElementForm::toggleBuilding);
}

void ElementForm::browse() {
    const QString file = askForGlazing(this);
    if (file.isEmpty()) return;
    settings_.windows = file.toStdString();
    Q_EMIT edited(settings_, tr("windows"));
}

void ElementForm::toggleBuilding() {
    if (building_.isEmpty()) return;
    auto& names = settings_.buildings;
    const std::string id = building_.toStdString();
    const auto found = std::ranges::find(names, id);
    found == names.end() ? names.push_back(id) : void(names.erase(found));
    Q_EMIT edited(settings_, tr("buildings"));
    show(settings_);
}

void ElementForm::show(const ElementSettings& settings) {
    settings_ = settings;
    buildings_->setText(joinNames(settings.buildings));
    file_->setText(QString::fromStdString(settings.windows.string()));
    rows_->show(elementFields().of(settings));
    proposed_->setChecked(settings.proposed);
    faces_->show(settings.faces);
    lines_->show(settings.parcel, settings.lines);
    list_->show(settings.points);
    showRows();
    showButton();
}

void ElementForm::showRows() {
    const auto visible = [this](QWidget* field, bool shown) { form_->setRowVisible(field, shown); };
    const bool facades = settings_.places == ElementPlaces::facades;
    const bool windows = settings_.places == ElementPlaces::windows;
    const bool lines = settings_.places == ElementPlaces::lines;
    visible(buildings_->parentWidget(), facades);
    buildings_->parentWidget()->setEnabled(!settings_.proposed);
    visible(proposed_, facades);
    visible(faces_, facades || windows);
    faces_->setPickable(facades);
    visible(lines_, lines);
    visible(list_, settings_.places == ElementPlaces::points);
    visible(file_->parentWidget(), windows);
    for (const std::string_view flag :
         {"--window-heights", "--bay", "--storey", "--above-floor", "--plane-height"})
        visible(rows_->widget(flag), applies(flag));
}

bool ElementForm::applies(std::string_view flag) const {
    const Described fields = elementFields().of(settings_);
    const auto field = std::ranges::find(fields.fields, flag, &Field::flag);
    // A review measures windows, in their middle.
    return fields.applies(*field) && (use_ == Use::study || flag != "--above-floor");
}

void ElementForm::setBuilding(const QString& id) {
    building_ = id;
    showButton();
}

void ElementForm::showButton() {
    const auto& names = settings_.buildings;
    const bool chosen = std::ranges::find(names, building_.toStdString()) != names.end();
    selected_->setEnabled(!building_.isEmpty());
    selected_->setText(chosen ? tr("Remove") : tr("Add selected"));
}

}  // namespace noonmark
