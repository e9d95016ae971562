#include "app/gui/docks/study_form/accuracy_section.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>

#include "app/gui/base/widgets/folded_section.h"
#include "app/gui/base/widgets/length_field.h"
#include "app/gui/base/widgets/push_button.h"
#include "app/gui/docks/study_form/accuracy_choice.h"
#include "app/gui/docks/study_form/accuracy_form.h"
#include "app/input/all_engines.h"

namespace noonmark {

AccuracySection::AccuracySection(QWidget* parent)
    : QWidget(parent),
      cell_(lengthField(ReceiverSettings::minCellM, ReceiverSettings::maxCellM, 2, 0.25)),
      choice_(new QComboBox),
      about_(new QLabel),
      form_(new AccuracyForm(allEngines())) {
    makeFields();
    connectFields();
    showChoice();
}

void AccuracySection::makeFields() {
    cell_->setObjectName(QStringLiteral("cell"));
    cell_->setToolTip(tr("Side of a cell on the ground. Half the size: four times the cells"));
    choice_->setObjectName(QStringLiteral("accuracy"));
    for (const AccuracyChoice choice : allAccuracyChoices) {
        choice_->addItem(nameOf(choice));
        choice_->setItemData(choice_->count() - 1, describe(choice), Qt::ToolTipRole);
    }
    about_->setWordWrap(true);
    about_->setForegroundRole(QPalette::PlaceholderText);
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(12, 0, 0, 0);
    column->addWidget(form_);
    auto* paper =
        pushButton(tr("As in the paper"), "asInPaper",
                   tr("Exploration by shadow accrual maps, analysis by inverse accrual maps through "
                      "the direction graph,\nas published. Approximate: the legend states the "
                      "measured error"));
    column->addWidget(paper);
    connect(paper, &QPushButton::clicked, this, &AccuracySection::paperRequested);
    method_ = new FoldedSection(tr("Method and options"), "methodDetails", content);
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(tr("Cell size"), cell_);
    form->addRow(tr("Accuracy"), choice_);
    form->addRow(about_);
    form->addRow(method_);
}

void AccuracySection::connectFields() {
    connect(cell_, &QDoubleSpinBox::valueChanged, this, [this](double cellM) {
        settings_.receivers.cellM = cellM;
        Q_EMIT edited(settings_, tr("cell size"));
    });
    connect(choice_, &QComboBox::activated, this, [this](int chosen) {
        const auto choice = allAccuracyChoices[std::size_t(chosen)];
        if (choice == AccuracyChoice::own) method_->setFolded(false);
        Q_EMIT edited(applied(choice, settings_, terrain_), tr("accuracy"));
        showChoice();
    });
    connect(form_, &AccuracyForm::edited, this, [this](const QString& field) {
        settings_ = form_->applied(settings_);
        Q_EMIT edited(settings_, field);
    });
}

void AccuracySection::show(const StudySettings& settings) {
    settings_ = settings;
    const QSignalBlocker quiet(cell_);
    cell_->setValue(settings.receivers.cellM);
    form_->show(settings);
    showChoice();
}

void AccuracySection::setTerrain(bool terrain) {
    terrain_ = terrain;
    showChoice();
}

void AccuracySection::showChoice() {
    const QSignalBlocker quiet(choice_);
    const AccuracyChoice choice = choiceOf(settings_, terrain_);
    choice_->setCurrentIndex(int(std::ranges::find(allAccuracyChoices, choice) - allAccuracyChoices.begin()));
    about_->setText(describe(choice));
}

}  // namespace noonmark
