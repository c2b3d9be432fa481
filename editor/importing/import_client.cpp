// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/import_client.h"

#include <algorithm>
#include <QCoreApplication>
#include <QSet>

namespace detent::editor {
namespace {

/// Threads whose owner may have been destroyed. The program must not end before them. GUI thread.
QSet<QThread*>& liveThreads() {
  static QSet<QThread*> threads;
  return threads;
}

void waitForThreads() {
  const QSet<QThread*> threads = liveThreads();
  for (QThread* thread : threads) {
    thread->quit();
    thread->wait();
  }
}

QThread* newThread() {
  static const bool registered = [] {
    qAddPostRoutine(waitForThreads);
    return true;
  }();
  Q_UNUSED(registered);
  auto* thread = new QThread;
  thread->setObjectName(QStringLiteral("import"));
  liveThreads().insert(thread);
  QObject::connect(thread, &QThread::finished, thread, &QObject::deleteLater);
  QObject::connect(thread, &QObject::destroyed, [thread] { liveThreads().remove(thread); });
  return thread;
}

bool isFailure(const Answer& answer) {
  if (const auto* imported = std::get_if<ImportedGraph>(&answer)) return imported->failure.has_value();
  return std::holds_alternative<Failure>(answer);
}

}  // namespace

ImportClient::ImportClient(QObject* parent)
    : QObject(parent), thread_(newThread()), worker_(new ImportWorker) {
  worker_->moveToThread(thread_);
  connect(thread_, &QThread::finished, worker_, &QObject::deleteLater);
  connect(worker_, &ImportWorker::answered, this, &ImportClient::finish);
  connect(worker_, &ImportWorker::progressed, this,
          [this](Ticket ticket, double fraction, importer::ImportStep step) {
            if (running_ && running_->question.ticket == ticket && !running_->forgotten)
              emit progressed(ticket, fraction, step);
          });
  thread_->start(QThread::LowPriority);
}

ImportClient::~ImportClient() {
  if (running_) running_->stop->store(true);
  thread_->quit();
}

void ImportClient::enqueue(Question question, bool before) {
  const auto place = std::find_if(queue_.begin(), queue_.end(), [&](const Question& other) {
    return before ? other.urgency <= question.urgency : other.urgency < question.urgency;
  });
  queue_.insert(place, std::move(question));
}

ImportClient::Ticket ImportClient::ask(Query query, Urgency urgency) {
  const Ticket ticket = ++last_;
  enqueue({ticket, std::move(query), urgency}, false);
  const bool inTheWay =
      running_ && running_->question.urgency == Urgency::background && urgency > Urgency::background;
  if (inTheWay && !running_->forgotten) {
    running_->interrupted = true;
    running_->stop->store(true);
  }
  startNext();
  return ticket;
}

void ImportClient::forget(Ticket ticket) {
  queue_.remove_if([ticket](const Question& question) { return question.ticket == ticket; });
  if (!running_ || running_->question.ticket != ticket) return;
  running_->forgotten = true;
  running_->stop->store(true);
}

void ImportClient::forgetAll() {
  queue_.clear();
  if (running_) forget(running_->question.ticket);
}

bool ImportClient::isOpen(Ticket ticket) const {
  if (running_ && running_->question.ticket == ticket) return !running_->forgotten;
  return std::any_of(queue_.begin(), queue_.end(),
                     [ticket](const Question& q) { return q.ticket == ticket; });
}

void ImportClient::startNext() {
  if (running_ || queue_.empty()) return;
  running_ = Running{std::move(queue_.front()), std::make_shared<std::atomic<bool>>(false)};
  queue_.pop_front();
  const Question& question = running_->question;
  ImportWorker* worker = worker_;
  QMetaObject::invokeMethod(
      worker,
      [worker, ticket = question.ticket, query = question.query, stop = running_->stop] {
        worker->answer(ticket, query, stop);
      },
      Qt::QueuedConnection);
}

void ImportClient::finish(Ticket ticket, const std::shared_ptr<const Answer>& answer) {
  Running done = std::move(*running_);
  running_.reset();
  if (done.interrupted && !done.forgotten && isFailure(*answer)) {
    enqueue(std::move(done.question), true);
    done.forgotten = true;
  }
  startNext();
  if (!done.forgotten) emit answered(ticket, answer);
}

}  // namespace detent::editor
