#include "app/gui/session/project/recent_files.h"

#include <QBuffer>
#include <QFileInfo>
#include <QSettings>
#include <QVariantMap>
#include <algorithm>

#include "core/io/settings/read_settings.h"

namespace noonmark {

namespace {

const QString key = QStringLiteral("recentFiles");
// per entry; only settings that differ from the defaults
const QString readingKey = QStringLiteral("recentReading");

const QString picturesKey = QStringLiteral("recentPictures");  // per entry, JPEG
const QString samplePrefix = QStringLiteral("sample:");
constexpr int pictureQuality = 85;  // of JPEG: some 8 KB for a picture

// The middle of the picture in the proportions of the small one.
QImage shrink(const QImage& picture) {
    const QSize size = RecentFiles::pictureSize;
    const QImage filled = picture.scaled(size, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    return filled.copy((filled.width() - size.width()) / 2, (filled.height() - size.height()) / 2,
                       size.width(), size.height());
}

QString absolute(const QString& file) {
    return file.startsWith(samplePrefix) ? file : QFileInfo(file).absoluteFilePath();
}

}  // namespace

RecentFiles::RecentFiles(QSettings& settings) : settings_(settings) {}

QStringList RecentFiles::entries() const { return settings_.value(key).toStringList(); }

void RecentFiles::add(const QStringList& files, const ReadSettings& reading) {
    QStringList paths;
    for (const QString& file : files) paths << absolute(file);
    const QString entry = paths.join(QLatin1Char('\n'));
    QStringList list = entries();
    list.removeAll(entry);
    list.prepend(entry);
    list = list.mid(0, maximum);
    settings_.setValue(key, list);
    keepReading(list, entry, reading);
    keepPictures(list);
}

void RecentFiles::keepPictures(const QStringList& entries) {
    QVariantMap pictures = settings_.value(picturesKey).toMap();
    for (const QString& entry : pictures.keys())
        if (!entries.contains(entry)) pictures.remove(entry);
    settings_.setValue(picturesKey, pictures);
}

QImage RecentFiles::pictureOf(const QString& entry) const {
    return QImage::fromData(settings_.value(picturesKey).toMap().value(entry).toByteArray());
}

void RecentFiles::setPicture(const QString& entry, const QImage& picture) {
    if (picture.isNull() || !entries().contains(entry)) return;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    shrink(picture).save(&buffer, "JPEG", pictureQuality);
    QVariantMap pictures = settings_.value(picturesKey).toMap();
    pictures[entry] = bytes;
    settings_.setValue(picturesKey, pictures);
}

bool RecentFiles::isSampleEntry(const QString& entry) { return entry.startsWith(samplePrefix); }

bool RecentFiles::exists(const QString& entry) {
    if (isSampleEntry(entry)) return true;
    const QStringList files = filesOf(entry);
    return std::ranges::all_of(files, [](const QString& file) { return QFileInfo::exists(file); });
}

void RecentFiles::keepReading(const QStringList& entries, const QString& newest,
                              const ReadSettings& reading) {
    QVariantMap saved;
    for (const QString& entry : entries) {
        const QString text =
            entry == newest ? QString::fromStdString(formatText(reading)) : readingTextOf(entry);
        if (!text.isEmpty()) saved[entry] = text;
    }
    settings_.setValue(readingKey, saved);
}

QString RecentFiles::readingTextOf(const QString& entry) const {
    return settings_.value(readingKey).toMap().value(entry).toString();
}

ReadSettings RecentFiles::readingOf(const QString& entry) const {
    return readSettingsFrom(readingTextOf(entry).toStdString()).value_or(ReadSettings{});
}

void RecentFiles::clear() {
    settings_.remove(key);
    settings_.remove(readingKey);
    settings_.remove(picturesKey);
}

QStringList RecentFiles::filesOf(const QString& entry) { return entry.split(QLatin1Char('\n')); }

QString RecentFiles::nameOf(const QString& entry) {
    const QStringList files = filesOf(entry);
    const QString first = QFileInfo(files.front()).fileName();
    return files.size() == 1 ? first : QStringLiteral("%1 and %2 more").arg(first).arg(files.size() - 1);
}

}  // namespace noonmark
