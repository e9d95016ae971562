#include "app/gui/docks/study_form/accuracy_section.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QObject>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>

#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/field_rows.h"
#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/input/all_engines.h"
#include "core/describe/field_values.h"

namespace noonmark {

namespace {

constexpr std::string_view automatic = "auto", polygons = "projected", inverseMaps = "iam";

std::string_view engineOf(AccuracyChoice choice, const StudySettings& settings, bool terrain) {
    const bool level = !terrain && settings.receivers.places == ReceiverPlaces::ground;
    if (choice == AccuracyChoice::quick) return automatic;
    if (choice == AccuracyChoice::exact && level) return polygons;
    return referenceEngine;
}

StudySettings withEngine(StudySettings settings, std::string_view engine) {
    settings.engine = std::string(engine);
    settings.engineSettings.clear();
    return settings;
}

}  // namespace

QString nameOf(AccuracyChoice choice) {
    switch (choice) {
        case AccuracyChoice::quick:
            return QObject::tr("Quick");
        case AccuracyChoice::exact:
            return QObject::tr("Exact");
        case AccuracyChoice::reference:
            return QObject::tr("Reference (rays)");
        case AccuracyChoice::own:
            return QObject::tr("Own settings");
    }
    return {};
}

QString describe(AccuracyChoice choice) {
    switch (choice) {
        case AccuracyChoice::quick:
            return QObject::tr(
                "Exact where that is quick; over long periods off by 0.04 % of the time on average, and the "
                "error is measured");
        case AccuracyChoice::exact:
            return QObject::tr("The outline of every shadow at every step, without rounding");
        case AccuracyChoice::reference:
            return QObject::tr("One ray for every cell and step: what the other ways are checked against");
        case AccuracyChoice::own:
            return QObject::tr("The method and the options chosen below");
    }
    return {};
}

StudySettings withAccuracy(AccuracyChoice choice, StudySettings settings, bool terrain) {
    if (choice == AccuracyChoice::own) return settings;
    return withEngine(settings, engineOf(choice, settings, terrain));
}

AccuracyChoice choiceOf(const StudySettings& settings, bool terrain) {
    if (!settings.engineSettings.empty()) return AccuracyChoice::own;
    for (const AccuracyChoice choice :
         {AccuracyChoice::quick, AccuracyChoice::reference, AccuracyChoice::exact})
        if (settings.engine == engineOf(choice, settings, terrain)) return choice;
    return AccuracyChoice::own;
}

StudySettings asInPaper(StudySettings settings) { return withEngine(std::move(settings), inverseMaps); }

bool isAsInPaper(const StudySettings& settings) { return settings.engine == inverseMaps; }

namespace {

QString text(std::string_view view) { return QString::fromUtf8(view.data(), qsizetype(view.size())); }

QString tipOf(const Field& option) {
    const QString about = translated(option.help);
    if (option.kind == ValueKind::yesNo)
        return QObject::tr("%1.\nDefault: %2")
            .arg(about, option.standard == Value(true) ? QObject::tr("yes") : QObject::tr("no"));
    return QObject::tr("%1.\n%2 to %3 %4, usually %5")
        .arg(about, formatShort(option.range->min, 6), formatShort(option.range->max, 6), text(option.unit),
             QString::fromStdString(formatText(option.standard)));
}

}  // namespace

AccuracyForm::~AccuracyForm() = default;

AccuracyForm::AccuracyForm(const EngineList& engines, QWidget* parent)
    : QWidget(parent), engines_(engines), engine_(new QComboBox), form_(new QFormLayout(this)) {
    fillEngines();
    form_->setContentsMargins(0, 0, 0, 0);
    form_->addRow(tr("Method"), engine_);
    fixedRows_ = form_->rowCount();
    connect(engine_, &QComboBox::currentIndexChanged, this, [this] {
        chooseEngine();
        Q_EMIT edited(tr("method"));
    });
    chooseEngine();
}

void AccuracyForm::fillEngines() {
    engine_->setObjectName(QStringLiteral("engine"));
    engine_->setToolTip(
        tr("How the shadow is computed; the ray reference is the standard for the errors of the others"));
    // A long engine name must not widen the dock.
    engine_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    engine_->setMinimumContentsLength(18);
    for (const auto& [engine, make] : engines_) {
        engine_->addItem(translated(engine.name), text(engine.key));
        engine_->setItemData(engine_->count() - 1, translated(engine.about), Qt::ToolTipRole);
    }
}

void AccuracyForm::chooseEngine() {
    const std::string key = engine_->currentData().toString().toStdString();
    const EngineEntry* engine = findEngine(engines_, key);
    if (engine && key != shown_) makeFields(engine->info);
}

void AccuracyForm::makeFields(const EngineInfo& engine) {
    while (form_->rowCount() > fixedRows_) form_->removeRow(fixedRows_);
    shown_ = engine.key;
    options_ = engine.options;
    rows_ = std::make_unique<FieldRows>(options_);
    rows_->addRows(*form_);
    for (const Field& option : options_) {
        QWidget* widget = rows_->widget(option.key);
        widget->setObjectName(QStringLiteral("option_") + text(option.key));
        widget->setToolTip(tipOf(option));
    }
    connect(rows_.get(), &FieldRows::edited, this, &AccuracyForm::edited);
}

void AccuracyForm::show(const StudySettings& settings) {
    const QSignalBlocker quiet(this);
    engine_->setCurrentIndex(engine_->findData(QString::fromStdString(settings.engine)));
    rows_->show({options_, &settings.engineSettings});
}

StudySettings AccuracyForm::withFields(StudySettings settings) const {
    settings.engine = shown_;
    settings.engineSettings.clear();
    rows_->take({options_, &settings.engineSettings});
    return settings;
}

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
        Q_EMIT edited(withAccuracy(choice, settings_, terrain_), tr("accuracy"));
        showChoice();
    });
    connect(form_, &AccuracyForm::edited, this, [this](const QString& field) {
        settings_ = form_->withFields(settings_);
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
