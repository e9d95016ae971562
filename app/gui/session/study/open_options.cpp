#include "app/gui/session/study/open_options.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/widgets/reading_form.h"
#include "app/gui/session/study/field_choices.h"
#include "app/gui/session/study/massing_preview.h"

namespace noonmark {

namespace {

constexpr qsizetype maxNames = 6;
constexpr int pauseMs = 400;  // between an edit and the reading that it causes

QString namesOf(const QStringList& files) {
    QStringList names;
    for (const QString& file : files.first(std::min(files.size(), maxNames)))
        names << QFileInfo(file).fileName();
    if (files.size() > maxNames) names << QObject::tr("and %1 more").arg(files.size() - maxNames);
    return names.join(QLatin1Char('\n'));
}

std::vector<std::filesystem::path> pathsOf(const QStringList& files) {
    std::vector<std::filesystem::path> paths;
    for (const QString& file : files) paths.emplace_back(file.toStdString());
    return paths;
}

}  // namespace

OpenOptions::OpenOptions(QWidget* parent)
    : QDialog(parent),
      names_(new QLabel),
      form_(new ReadingForm),
      choices_(new FieldChoices(*form_)),
      preview_(new MassingPreview),
      pause_(new QTimer(this)) {
    setObjectName(QStringLiteral("openOptions"));
    setWindowTitle(tr("Open with options"));
    names_->setObjectName(QStringLiteral("files"));
    names_->setTextFormat(Qt::PlainText);
    auto* add = new QPushButton(tr("Add terrain or surface model..."));
    add->setObjectName(QStringLiteral("addFiles"));
    add->setAutoDefault(false);  // Enter must trigger Open
    add->setToolTip(
        tr("Reads elevations together with the buildings. Of a surface model and a terrain, "
           "missing heights are the difference."));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Open)->setToolTip(tr("Read the files with these settings"));
    auto* side = new QVBoxLayout;
    side->addWidget(names_);
    side->addWidget(add, 0, Qt::AlignLeft);
    side->addWidget(preview_, 1);
    auto* halves = new QHBoxLayout;
    halves->addWidget(form_);
    halves->addLayout(side, 1);
    auto* column = new QVBoxLayout(this);
    column->addLayout(halves, 1);
    column->addWidget(buttons);
    column->setSizeConstraint(QLayout::SetMinimumSize);
    pause_->setSingleShot(true);
    pause_->setInterval(pauseMs);
    connect(pause_, &QTimer::timeout, this, &OpenOptions::readPreview);
    connect(form_, &ReadingForm::edited, pause_, qOverload<>(&QTimer::start));
    connect(choices_, &FieldChoices::chosen, pause_, qOverload<>(&QTimer::start));
    connect(add, &QPushButton::clicked, this, [this] { addFiles(askForCity(this)); });
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(this, &QDialog::finished, this, &OpenOptions::stop);
    connect(this, &QDialog::accepted, this, [this] { Q_EMIT chosen(files_, form_->settings()); });
}

void OpenOptions::ask(const QStringList& files, const ReadSettings& settings) {
    files_ = files;
    form_->show(settings);
    showFiles();
    show();
    raise();
    activateWindow();
}

void OpenOptions::addFiles(const QStringList& files) {
    if (files.isEmpty()) return;
    for (const QString& file : files)
        if (!files_.contains(file)) files_ << file;
    ReadSettings settings = form_->settings();
    settings.heightsFromSurface = true;
    form_->show(settings);
    showFiles();
}

void OpenOptions::showFiles() {
    names_->setText(namesOf(files_));
    names_->setToolTip(files_.join(QLatin1Char('\n')));
    listFields();
    readPreview();
}

// A file that cannot be listed cannot be read either: the preview says why.
void OpenOptions::listFields() {
    using Listed = std::vector<FieldsOfFile>;
    listing_.start<Listed>(
        tr("Listing fields"),
        [files = files_](Progress&, const std::stop_token& stop) -> Result<Listed> {
            Listed listed;
            for (const QString& file : files)
                if (auto layers = listLayers(file.toStdString(), stop))
                    listed.push_back({file.toStdString(), *std::move(layers)});
            return listed;
        },
        [this](const Result<Listed>& listed) { choices_->show(listed.value_or(Listed{})); });
}

void OpenOptions::readPreview() {
    preview_->showWaiting();
    reading_.start<MassingSketch>(
        tr("Reading for the preview"),
        [paths = pathsOf(files_), settings = form_->settings()](
            Progress& progress, const std::stop_token& stop) -> Result<MassingSketch> {
            const auto read = readCity(paths, settings, progress, stop);
            if (!read) return tl::make_unexpected(read.error());
            return sketchMassing(read->city);
        },
        [this](Result<MassingSketch> sketch) { preview_->show(std::move(sketch)); });
}

void OpenOptions::stop() {
    pause_->stop();
    listing_.drop();
    reading_.drop();
}

void OpenOptions::setMiddle(std::optional<LonLat> middle) { form_->setMiddle(middle); }

}  // namespace noonmark
