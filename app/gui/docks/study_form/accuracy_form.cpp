#include "app/gui/docks/study_form/accuracy_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSignalBlocker>
#include <cmath>

#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/number_words.h"
#include "app/gui/base/widgets/translated.h"

namespace noonmark {

namespace {

QString text(std::string_view view) { return QString::fromUtf8(view.data(), qsizetype(view.size())); }

QString tipOf(const EngineOption& option) {
    if (option.kind == OptionKind::yesNo)
        return QObject::tr("%1.\nDefault: %2")
            .arg(translated(option.about), option.standard != 0 ? QObject::tr("yes") : QObject::tr("no"));
    return QObject::tr("%1.\n%2 to %3 %4, usually %5")
        .arg(translated(option.about), formatShort(option.min, 6), formatShort(option.max, 6),
             text(option.unit), formatShort(option.standard, 6));
}

// As many decimals as the option's own values have.
int decimalsOf(const EngineOption& option) {
    if (option.kind != OptionKind::number) return 0;
    for (int decimals = 2; decimals < 9; ++decimals) {
        const double grains = std::pow(10, decimals);
        const auto shows = [grains](double value) {
            return std::abs(std::round(value * grains) - value * grains) < 1e-6;
        };
        if (shows(option.standard) && shows(option.min)) return decimals;
    }
    return 9;
}

QDoubleSpinBox* numberFieldOf(const EngineOption& option) {
    const QString unit = option.unit.empty() ? QString() : QLatin1Char(' ') + text(option.unit);
    // A default of 0 that is also the minimum means that the engine chooses.
    const bool byItself = option.standard == 0 && option.min == 0;
    const double step = option.kind != OptionKind::number ? 1
                        : byItself                        ? option.max / 20
                                                          : option.standard / 10;
    QDoubleSpinBox* box = numberField(option.min, option.max, decimalsOf(option), step, unit);
    if (byItself) box->setSpecialValueText(QObject::tr("automatic"));
    if (option.standard == -1 && option.min == -1)
        box->setSpecialValueText(QObject::tr("none: the processor"));
    return box;
}

}  // namespace

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
    fields_.clear();
    shown_ = std::string(engine.key);
    for (const EngineOption& option : engine.options) addField(option);
}

void AccuracyForm::addField(const EngineOption& option) {
    const auto tell = [this, name = translated(option.name)] { Q_EMIT edited(name); };
    if (option.kind == OptionKind::yesNo) {
        auto* box = new QCheckBox(translated(option.name));
        fields_.push_back({option, box, nullptr, box});
        form_->addRow(box);
        connect(box, &QCheckBox::toggled, this, tell);
    } else {
        QDoubleSpinBox* box = numberFieldOf(option);
        fields_.push_back({option, box, box, nullptr});
        form_->addRow(translated(option.name), box);
        connect(box, &QDoubleSpinBox::valueChanged, this, tell);
    }
    const QSignalBlocker quiet(this);
    const Field& field = fields_.back();
    field.widget->setObjectName(QStringLiteral("option_") + text(option.key));
    field.widget->setToolTip(tipOf(option));
    setValue(field, option.standard);
}

void AccuracyForm::setValue(const Field& field, double value) {
    if (field.check != nullptr)
        field.check->setChecked(value != 0);
    else
        field.number->setValue(value);
}

void AccuracyForm::show(const StudySettings& settings) {
    const QSignalBlocker quiet(this);
    engine_->setCurrentIndex(engine_->findData(QString::fromStdString(settings.engine)));
    for (const Field& field : fields_) {
        const auto set = settings.engineSettings.find(field.option.key);
        setValue(field, set == settings.engineSettings.end() ? field.option.standard : set->second);
    }
}

StudySettings AccuracyForm::applied(StudySettings settings) const {
    settings.engine = shown_;
    settings.engineSettings.clear();
    for (const Field& field : fields_) {
        const double value =
            field.check != nullptr ? double(field.check->isChecked()) : field.number->value();
        const double halfGrain = field.check != nullptr ? 0.5 : 0.5 * std::pow(10, -field.number->decimals());
        if (std::abs(value - field.option.standard) >= halfGrain)
            settings.engineSettings.emplace(field.option.key, value);
    }
    return settings;
}

}  // namespace noonmark
