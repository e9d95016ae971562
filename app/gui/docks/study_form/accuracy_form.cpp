#include "app/gui/docks/study_form/accuracy_form.h"

#include <QComboBox>
#include <QFormLayout>
#include <QSignalBlocker>

#include "app/gui/base/widgets/field_rows.h"
#include "app/gui/base/widgets/number_words.h"
#include "app/gui/base/widgets/translated.h"
#include "core/describe/value_text.h"

namespace noonmark {

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

StudySettings AccuracyForm::applied(StudySettings settings) const {
    settings.engine = shown_;
    settings.engineSettings.clear();
    rows_->take({options_, &settings.engineSettings});
    return settings;
}

}  // namespace noonmark
