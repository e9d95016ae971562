#include "app/gui/tools/photograph/photograph_actions.h"

#include <QFileInfo>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/base/widgets/status_bars.h"
#include "app/gui/session/workbench.h"
#include "app/gui/tools/photograph/photograph_dialog.h"
#include "core/city/map_context.h"
#include "core/io/files/check_output.h"
#include "core/io/pictures/ground_raster_file.h"

namespace noonmark {

PhotographActions::PhotographActions(Workbench& workbench, MessageBar& messages, QWidget& window)
    : workbench_(workbench),
      messages_(messages),
      window_(window),
      ask_(makeAction(this, tr("Aer&ial photograph..."), {},
                      tr("An orthophoto or a scanned map with its position, drawn on the ground of the view, "
                         "on maps and on sheets"))),
      show_(makeAction(this, tr("Aerial photo&graph"), {}, tr("Shows or hides the aerial photograph"))) {
    show_->setCheckable(true);
    connect(ask_, &QAction::triggered, this, &PhotographActions::ask);
    connect(show_, &QAction::triggered, this, [this](bool on) {
        auto file = workbench_.session().project().groundPicture;
        if (!file) return ask();
        file->shown = on;
        set(file);
    });
    connect(&workbench_.session(), &ProjectSession::changed, this, &PhotographActions::follow);
    connect(&workbench_, &Workbench::cityShown, this, &PhotographActions::follow);
    follow();
}

void PhotographActions::follow() {
    const auto& file = workbench_.session().project().groundPicture;
    show_->setChecked(file && file->shown);
    const auto& context = workbench_.session().project().city->context;
    if (file && context && context->picture) atHand_ = Photograph{*file, context->picture->raster};
}

void PhotographActions::ask() {
    if (!workbench_.city()) return messages_.showError(noCityError());
    PhotographDialog dialog(
        workbench_.session().project().groundPicture, [this] { return askForPhotograph(&window_); },
        &window_);
    const int result = dialog.exec();
    if (result == QDialog::Accepted) set(dialog.picture());
    follow();
    if (result == PhotographDialog::tilesRequested) askForTiles();
}

void PhotographActions::askForTiles() {
    const City& city = workbench_.city()->city();
    TileDialog dialog(chooseTiles(city.frame, photographBox(city)), &window_);
    if (dialog.exec() != QDialog::Accepted) return;
    const int missing = dialog.fetch().missing(), tiles = dialog.fetch().range().count();
    if (missing > 0)
        messages_.showNote(tr("%1 of %2 tile(s) are missing and stay empty", "", tiles)
                               .arg(formatCount(quint64(missing)), formatCount(quint64(tiles))));
    const QString file = askWhereToSavePhotograph(&window_);
    if (!file.isEmpty()) saveTiles(file, dialog.fetch(), dialog.attribution().toStdString());
}

void PhotographActions::saveTiles(const QString& file, const TileFetch& tiles,
                                  const std::string& attribution) {
    const QImage image = tiles.picture();
    PlacedPicture picture{image.width(),
                          image.height(),
                          {},
                          "EPSG:3857",
                          computeTransform(tiles.range(), image.width() / tiles.range().columns),
                          attribution};
    picture.rgba.assign(image.constBits(), image.constBits() + image.sizeInBytes());
    const GroundPictureFile wanted{file.toStdString(), {}, attribution};
    start([wanted, picture = std::move(picture), city = workbench_.session().project().city](
              Progress& progress, const std::stop_token& stop) {
        return checkOutput(wanted.path, OutputKind::geoTiff, {.overwrite = true})
            .and_then([&] { return writePicture(wanted.path, picture); })
            .and_then([&] { return loadPhotograph(wanted, *city, progress, stop); });
    });
}

void PhotographActions::set(const std::optional<GroundPictureFile>& wanted) {
    if (!workbench_.city()) return;
    const bool known =
        wanted && atHand_ && atHand_->file.path == wanted->path && atHand_->file.sha256 == wanted->sha256;
    if (!wanted || known) return change(wanted);
    start([wanted = *wanted, city = workbench_.session().project().city](Progress& progress,
                                                                         const std::stop_token& stop) {
        return loadPhotograph(wanted, *city, progress, stop);
    });
}

void PhotographActions::start(std::function<Result<Photograph>(Progress&, std::stop_token)> read) {
    reading_.start<Photograph>(tr("Reading the photograph"), std::move(read),
                               [this](Result<Photograph> made) {
                                   if (made) return take(*std::move(made));
                                   follow();
                                   if (!isCancelled(made.error())) messages_.showError(made.error());
                               });
}

void PhotographActions::take(Photograph photograph) {
    atHand_ = std::move(photograph);
    change(GroundPictureFile(atHand_->file));
}

void PhotographActions::change(const std::optional<GroundPictureFile>& file) {
    const Project& now = workbench_.session().project();
    if (file == now.groundPicture && (!file || now.city->context)) return;
    workbench_.session().change(withGroundPicture(now, file, file ? atHand_->raster : nullptr),
                                file ? tr("aerial photograph") : tr("remove aerial photograph"));
}

bool isPhotograph(const QStringList& files) {
    static const QStringList endings{QStringLiteral("tif"), QStringLiteral("tiff"), QStringLiteral("img")};
    return files.size() == 1 && endings.contains(QFileInfo(files.front()).suffix().toLower()) &&
           isGroundPicture(files.front().toStdString());
}

}  // namespace noonmark
