// SPDX-License-Identifier: Apache-2.0
#include "runtime/live.h"

#include <errno.h>
#include <fmt/format.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "compiler/base/files.h"
#include "runtime/draw.h"
#include "runtime/job.h"

namespace texgraph::runtime {
namespace {

// What the parent tells the child before each picture: plain numbers, one after the other.
class Message {
 public:
  template <class T>
  void Put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    Put(&value, sizeof value);
  }
  void Put(const void* data, size_t size) {
    const auto* bytes = static_cast<const uint8_t*>(data);
    bytes_.insert(bytes_.end(), bytes, bytes + size);
  }
  // In the order of Put; what was put is there.
  template <class T>
  T Take() {
    T value;
    memcpy(&value, bytes_.data() + next_, sizeof value);
    next_ += sizeof value;
    return value;
  }
  void Take(std::vector<uint8_t>& to) {
    memcpy(to.data(), bytes_.data() + next_, to.size());
    next_ += to.size();
  }
  std::vector<uint8_t>& bytes() { return bytes_; }

 private:
  std::vector<uint8_t> bytes_;
  size_t next_ = 0;
};

// A file in memory that both processes have open: a message may be of any size, and neither waits
// for the other to read.
bool WriteAll(int file, const std::vector<uint8_t>& bytes) {
  if (ftruncate(file, static_cast<off_t>(bytes.size())) != 0) return false;
  for (size_t done = 0; done < bytes.size();) {
    const ssize_t size =
        pwrite(file, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return false;
    done += static_cast<size_t>(size);
  }
  return true;
}

bool ReadAll(int file, std::vector<uint8_t>& bytes) {
  for (size_t done = 0; done < bytes.size();) {
    const ssize_t size =
        pread(file, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return false;
    done += static_cast<size_t>(size);
  }
  return true;
}

}  // namespace

class LiveRenderer::Process {
 public:
  explicit Process(RenderRequest request) : request_(std::move(request)) {}
  ~Process();

  bool Open(Diagnostics& diagnostics);
  RenderResult Draw(double time);
  // The index of the texture's sampler in the plan; nothing if the shader does not use it.
  std::optional<size_t> FindSampler(const ManifestTexture& texture) const;

  RenderRequest& request() { return request_; }
  const RenderPlan& plan() const { return job_.plan; }
  void Add(size_t sampler, TexelUpdate update) {
    updates_.emplace_back(sampler, std::move(update));
  }

 private:
  bool Connect(Diagnostics& diagnostics);
  Child::Event Start(const ContextOptions& options, std::string& why_not);
  void Serve(const ContextOptions& options, const std::function<void()>& notify);
  bool Receive(Drawing& drawing);
  bool Send();

  RenderRequest request_;
  Job job_{&request_, nullptr, {}, {}};
  std::unique_ptr<Child> child_;
  int ends_[2] = {-1,
                  -1};  // of a socket; a byte in it is a message in the mailbox: ours, the child's
  int mailbox_ = -1;
  // Since the last picture, each with its sampler.
  std::vector<std::pair<size_t, TexelUpdate>> updates_;
  std::string context_note_;
  bool has_failed_ = false;
};

LiveRenderer::Process::~Process() {
  child_.reset();
  for (int descriptor : {ends_[0], ends_[1], mailbox_}) {
    if (descriptor >= 0) close(descriptor);
  }
}

std::optional<size_t> LiveRenderer::Process::FindSampler(const ManifestTexture& texture) const {
  const auto& samplers = job_.plan.samplers;
  for (size_t i = 0; i < samplers.size(); ++i) {
    if (texture.is_used && samplers[i].variable == texture.variable) return i;
  }
  return std::nullopt;
}

// --- In the child

// What changed since the last picture. False at the end of all pictures.
bool LiveRenderer::Process::Receive(Drawing& drawing) {
  uint64_t size = 0;
  ssize_t got = 0;
  while ((got = recv(ends_[1], &size, sizeof size, MSG_WAITALL)) < 0 && errno == EINTR) {
  }
  if (got != sizeof size) return false;
  Message message;
  message.bytes().resize(size);
  if (!ReadAll(mailbox_, message.bytes())) return false;
  request_.time = message.Take<double>();
  if (request_.scene) request_.scene->camera = message.Take<Camera>();
  for (ManifestParameter& parameter : request_.manifest.parameters) {
    for (double& number : parameter.value) number = message.Take<double>();
  }
  for (uint64_t left = message.Take<uint64_t>(); left > 0; --left) {
    const auto sampler = message.Take<uint64_t>();
    TexelUpdate update;
    for (uint32_t* number :
         {&update.level, &update.x, &update.y, &update.layer, &update.width, &update.height}) {
      *number = message.Take<uint32_t>();
    }
    update.texels.resize(message.Take<uint64_t>());
    message.Take(update.texels);
    if (!drawing.Update(sampler, update)) return true;
  }
  drawing.SetValues();
  return true;
}

void LiveRenderer::Process::Serve(const ContextOptions& options,
                                  const std::function<void()>& notify) {
  close(ends_[0]);  // else this process would never see that the other one is gone
  SharedResult& shared = *job_.shared;
  shared.stage = Stage::kOpening;
  std::string why_not;
  const std::unique_ptr<GlContext> context = OpenContext(options, why_not);
  SharedResult::SetText(shared.context_note, why_not);
  if (!context) {
    shared.Fail(DiagnosticKind::kNoContext, fmt::format("there is no OpenGL context: {}", why_not));
    notify();
    return;
  }
  SharedResult::SetText(shared.context, context->description);
  Drawing drawing(*context, request_, job_.plan, shared);
  bool is_ready = drawing.Prepare();
  notify();
  while (is_ready && Receive(drawing)) {
    is_ready = shared.failed == 0 && drawing.Draw();
    shared.stage = Stage::kDone;
    notify();
  }
}

// --- In the parent

bool LiveRenderer::Process::Connect(Diagnostics& diagnostics) {
  mailbox_ = memfd_create("texgraph-live", MFD_CLOEXEC);
  if (mailbox_ >= 0 && socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends_) == 0) return true;
  diagnostics.Error(DiagnosticKind::kDriverFailure, {},
                    fmt::format("cannot talk to a process for the driver: {}", ErrorText(errno)));
  return false;
}

Child::Event LiveRenderer::Process::Start(const ContextOptions& options, std::string& why_not) {
  child_ = std::make_unique<Child>();
  const bool started = child_->Start(
      request_.memory_limit, [&](const std::function<void()>& notify) { Serve(options, notify); },
      why_not);
  return started ? child_->Wait(request_.timeout) : Child::Event::kEnded;
}

bool LiveRenderer::Process::Open(Diagnostics& diagnostics) {
  if (!PlanRender(request_, job_.plan, diagnostics)) return false;
  if (!job_.shared.Allocate(job_.plan.bytes)) {
    diagnostics.Error(DiagnosticKind::kOutOfMemory, {},
                      "there is not enough memory for the picture");
    return false;
  }
  if (!Connect(diagnostics)) return false;
  RenderResult result;
  job_.result = &result;
  ContextOptions options = request_.context;
  std::string why_not;
  Child::Event event = Start(options, why_not);
  const bool is_opening = (*job_.shared).stage == Stage::kOpening;
  if (why_not.empty() && event != Child::Event::kNotified && is_opening &&
      options.choice == ContextChoice::kAuto) {
    // EGL took the process with it; what is left is OSMesa.
    const std::string how = event == Child::Event::kTimedOut ? "it hung" : child_->ending();
    context_note_ = fmt::format("EGL failed while opening a context ({})", how);
    options.choice = ContextChoice::kOsmesa;
    event = Start(options, why_not);
  }
  if (!why_not.empty()) {
    diagnostics.Error(DiagnosticKind::kDriverFailure, {},
                      fmt::format("cannot start a process for the driver: {}", why_not));
    return false;
  }
  if (event != Child::Event::kNotified) {
    CollectFailure(job_, *child_, event);
  } else if ((*job_.shared).failed != 0) {
    Collect(job_);
  }
  const bool ok = result.ok();
  diagnostics.Append(std::move(result.diagnostics));
  return ok;
}

bool LiveRenderer::Process::Send() {
  Message message;
  message.Put(request_.time);
  if (request_.scene) message.Put(request_.scene->camera);
  for (const ManifestParameter& parameter : request_.manifest.parameters) {
    message.Put(parameter.value.data(), parameter.value.size() * sizeof(double));
  }
  message.Put(uint64_t{updates_.size()});
  for (const auto& [sampler, update] : updates_) {
    message.Put(uint64_t{sampler});
    for (uint32_t number :
         {update.level, update.x, update.y, update.layer, update.width, update.height}) {
      message.Put(number);
    }
    message.Put(uint64_t{update.texels.size()});
    message.Put(update.texels.data(), update.texels.size());
  }
  updates_.clear();
  if (!WriteAll(mailbox_, message.bytes())) return false;
  // The socket has room: each message is read before the next is sent. A child that is gone is
  // told by its end.
  const uint64_t size = message.bytes().size();
  send(ends_[0], &size, sizeof size, MSG_NOSIGNAL);
  return true;
}

RenderResult LiveRenderer::Process::Draw(double time) {
  RenderResult result;
  result.context_note = context_note_;
  job_.result = &result;
  if (has_failed_) {
    result.diagnostics.Error(DiagnosticKind::kDriverFailure, {},
                             "the driver failed at an earlier picture");
    return result;
  }
  if (!std::isfinite(time)) {
    result.diagnostics.Error(DiagnosticKind::kUsage, {}, "the time is a finite number of seconds");
    return result;
  }
  request_.time = time;
  if (!Send()) {
    result.diagnostics.Error(DiagnosticKind::kOutOfMemory, {},
                             "there is not enough memory for the texels that change");
  } else if (const Child::Event event = child_->Wait(request_.timeout);
             event == Child::Event::kNotified) {
    Collect(job_);
  } else {
    CollectFailure(job_, *child_, event);
  }
  has_failed_ = !result.ok();
  return result;
}

LiveRenderer::LiveRenderer(std::unique_ptr<Process> process) : process_(std::move(process)) {}
LiveRenderer::~LiveRenderer() = default;

std::unique_ptr<LiveRenderer> LiveRenderer::Open(RenderRequest request, Diagnostics& diagnostics) {
  request.timed_frames = 0;
  auto process = std::make_unique<Process>(std::move(request));
  if (!process->Open(diagnostics)) return nullptr;
  return std::unique_ptr<LiveRenderer>(new LiveRenderer(std::move(process)));
}

RenderResult LiveRenderer::Draw(double time) { return process_->Draw(time); }

const RenderRequest& LiveRenderer::request() const { return process_->request(); }

bool LiveRenderer::SetParameter(std::string_view name, std::span<const double> numbers,
                                Diagnostics& diagnostics) {
  return runtime::SetParameter(name, numbers, process_->request().manifest, diagnostics);
}

bool LiveRenderer::SetCamera(const Camera& camera, Diagnostics& diagnostics) {
  RenderRequest& request = process_->request();
  if (!request.scene) {
    diagnostics.Error(DiagnosticKind::kUsage, {}, "there is no scene with a camera");
    return false;
  }
  const Camera before = request.scene->camera;
  request.scene->camera = camera;
  if (CheckScene(request, diagnostics)) return true;
  request.scene->camera = before;
  return false;
}

const ManifestTexture* LiveRenderer::Find(const std::string& name, std::optional<size_t>& sampler,
                                          Diagnostics& diagnostics) const {
  std::vector<std::string_view> names;
  for (const ManifestTexture& texture : process_->request().manifest.textures) {
    names.push_back(texture.name);
    if (texture.name != name) continue;
    if (texture.is_folded) {
      diagnostics.Error(DiagnosticKind::kNotRenderable, {},
                        fmt::format("the numbers of texture '{}' are part of this shader (folded)",
                                    Printable(name)));
      return nullptr;
    }
    sampler = process_->FindSampler(texture);
    return &texture;
  }
  diagnostics.Error(
      DiagnosticKind::kUnknownReference, {},
      fmt::format("the shader has no texture '{}'{}", Printable(name), DidYouMean(name, names)));
  return nullptr;
}

bool LiveRenderer::UpdateTexels(const TexelUpdate& update, Diagnostics& diagnostics) {
  std::optional<size_t> sampler;
  if (Find(update.texture, sampler, diagnostics) == nullptr) return false;
  if (!sampler) return true;
  if (!CheckUpdate(update, *process_->plan().samplers[*sampler].data, diagnostics)) return false;
  process_->Add(*sampler, update);
  return true;
}

bool LiveRenderer::UpdateMap(TexelUpdate update, std::span<const int32_t> numbers,
                             Diagnostics& diagnostics) {
  std::optional<size_t> sampler;
  const ManifestTexture* texture = Find(update.texture, sampler, diagnostics);
  if (texture == nullptr) return false;
  if (!sampler) return true;
  const auto count = texture->map ? texture->map->count : std::nullopt;
  return EncodeNumbers(numbers, *process_->plan().samplers[*sampler].data, count, update,
                       diagnostics) &&
         UpdateTexels(update, diagnostics);
}

std::optional<LiveRenderer::Texture> LiveRenderer::FindTexture(std::string_view name) const {
  for (const ManifestTexture& texture : process_->request().manifest.textures) {
    const std::optional<size_t> sampler = process_->FindSampler(texture);
    if (texture.name == name && sampler)
      return Texture{&texture, process_->plan().samplers[*sampler].data};
  }
  return std::nullopt;
}

}  // namespace texgraph::runtime
