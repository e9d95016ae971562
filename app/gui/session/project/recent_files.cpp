#include "app/gui/session/project/recent_files.h"

#include <QFileInfo>
#include <QSettings>
#include <QVariantMap>

#include "core/io/settings/read_settings_text.h"

namespace noonmark {

namespace {

const QString key = QStringLiteral("recentFiles");
// per entry; only settings that differ from the defaults
const QString readingKey = QStringLiteral("recentReading");

QString absolute(const QString& file) {
    return file.startsWith(QStringLiteral("sample:")) ? file : QFileInfo(file).absoluteFilePath();
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
    list = list.mid(0, most);
    settings_.setValue(key, list);
    keepReading(list, entry, reading);
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
}

QStringList RecentFiles::filesOf(const QString& entry) { return entry.split(QLatin1Char('\n')); }

QString RecentFiles::nameOf(const QString& entry) {
    const QStringList files = filesOf(entry);
    const QString first = QFileInfo(files.front()).fileName();
    return files.size() == 1 ? first : QStringLiteral("%1 and %2 more").arg(first).arg(files.size() - 1);
}

}  // namespace noonmark
