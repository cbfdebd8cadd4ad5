/* A renderer's loop in C: a ring of frames in flight, a camera that moves, another size in between. C99. */
#include <quell/quell.h>
#include <stdio.h>
#include <stdlib.h>

enum { kInFlight = 3, kFrames = 12, kResizedAt = 6, kChannels = 3, kInputs = 4 };
static const float kRadiance = 0.25f, kEncoded = 0.5325f; /* kEncoded: kRadiance to the power of 1/2.2 */

/* What one frame in flight has of its own: images, and the event after which they may be written again. */
typedef struct Slot {
  cl_mem inputs[kInputs]; /* radiance, normal, position, albedo */
  cl_mem display;
  cl_event done; /* NULL: no frame of this slot is pending */
} Slot;

typedef struct Renderer {
  cl_context context;
  cl_command_queue queue;
  quell_denoiser* denoiser;
  int width, height;
  Slot slots[kInFlight];
} Renderer;

static size_t bytesOf(const Renderer* renderer) {
  return (size_t)renderer->width * (size_t)renderer->height * kChannels * sizeof(float);
}

/* Stands for a path tracer: fills the images of a slot, and returns the event of its last command. */
static cl_event trace(const Renderer* renderer, const Slot* slot) {
  static const float kValues[kInputs] = {0.25f, 0.57735f, -2.0f, 0.5f};
  cl_event traced = NULL;
  for (int i = 0; i < kInputs; ++i)
    clEnqueueFillBuffer(renderer->queue, slot->inputs[i], &kValues[i], sizeof(float), 0, bytesOf(renderer), 0,
                        NULL, i + 1 < kInputs ? NULL : &traced);
  return traced;
}

static void waitForSlot(Slot* slot) {
  if (slot->done == NULL) return;
  clWaitForEvents(1, &slot->done);
  clReleaseEvent(slot->done);
  slot->done = NULL;
}

static void releaseSlots(Renderer* renderer) {
  for (int s = 0; s < kInFlight; ++s) {
    Slot* slot = &renderer->slots[s];
    waitForSlot(slot);
    for (int i = 0; i < kInputs; ++i)
      if (slot->inputs[i] != NULL) clReleaseMemObject(slot->inputs[i]);
    if (slot->display != NULL) clReleaseMemObject(slot->display);
    memset(slot, 0, sizeof(*slot));
  }
}

static void makeSlots(Renderer* renderer) {
  for (int s = 0; s < kInFlight; ++s) {
    for (int i = 0; i < kInputs; ++i)
      renderer->slots[s].inputs[i] =
          clCreateBuffer(renderer->context, CL_MEM_READ_WRITE, bytesOf(renderer), NULL, NULL);
    renderer->slots[s].display =
        clCreateBuffer(renderer->context, CL_MEM_READ_WRITE, bytesOf(renderer), NULL, NULL);
  }
}

/* The frame of a slot: layouts are those of every frame, memory is the slot's. */
static void describe(const Renderer* renderer, const Slot* slot, quell_frame* frame, quell_output* output) {
  QUELL_INIT(*frame);
  QUELL_INIT(*output);
  frame->width = renderer->width;
  frame->height = renderer->height;
  frame->radiance = quellPackedImage(slot->inputs[0], kChannels, QUELL_FLOAT32);
  frame->normalWorld = quellPackedImage(slot->inputs[1], kChannels, QUELL_FLOAT32);
  frame->positionWorld = quellPackedImage(slot->inputs[2], kChannels, QUELL_FLOAT32);
  frame->albedo = quellPackedImage(slot->inputs[3], kChannels, QUELL_FLOAT32);
  output->display = quellPackedImage(slot->display, kChannels, QUELL_FLOAT32);
}

/* Also after a change of size: what was accumulated stays. */
static quell_status resize(Renderer* renderer, int width, int height) {
  quell_frame frame;
  quell_output output;
  quell_prepare_options options;
  QUELL_INIT(options);
  options.keepHistory = 1;
  releaseSlots(renderer);
  renderer->width = width;
  renderer->height = height;
  makeSlots(renderer);
  describe(renderer, &renderer->slots[0], &frame, &output);
  return quellPrepareWith(renderer->denoiser, &frame, &output, &options);
}

static quell_status renderFrame(Renderer* renderer, int number) {
  Slot* slot = &renderer->slots[number % kInFlight];
  quell_frame frame;
  quell_output output;
  const double eye[3] = {0.05 * number, 0.0, 3.0}, target[3] = {0.05 * number, 0.0, 0.0}, up[3] = {0, 1, 0};
  waitForSlot(slot); /* the frame before the last two, long done where the device keeps up */
  cl_event traced = trace(renderer, slot);
  describe(renderer, slot, &frame, &output);
  quell_status status =
      quellSetLookAt(&frame.camera, eye, target, up, 60.0, (double)renderer->width / renderer->height);
  if (status == QUELL_SUCCESS)
    status = quellDenoise(renderer->denoiser, &frame, &output, 1, &traced, &slot->done);
  clReleaseEvent(traced);
  return status;
}

/* Half of every brightness is where it belongs, and no frame has failed. */
static int isRight(const Renderer* renderer, Slot* slot) {
  float pixel[kChannels];
  cl_int state = CL_COMPLETE;
  if (slot->done != NULL) {
    clWaitForEvents(1, &slot->done);
    clGetEventInfo(slot->done, CL_EVENT_COMMAND_EXECUTION_STATUS, sizeof(state), &state, NULL);
  }
  clEnqueueReadBuffer(renderer->queue, slot->display, CL_TRUE, bytesOf(renderer) / 2, sizeof(pixel), pixel, 0,
                      NULL, NULL);
  return state == CL_COMPLETE && pixel[0] > kEncoded - 0.001f && pixel[0] < kEncoded + 0.001f;
}

static int run(Renderer* renderer) {
  if (resize(renderer, 64, 48) != QUELL_SUCCESS) return 0;
  for (int number = 0; number < kFrames; ++number) {
    if (number == kResizedAt && resize(renderer, 96, 54) != QUELL_SUCCESS) return 0;
    if (renderFrame(renderer, number) != QUELL_SUCCESS) return 0;
  }
  for (int s = 0; s < kInFlight; ++s)
    if (!isRight(renderer, &renderer->slots[s])) return 0;
  return 1;
}

int main(void) {
  quell_device_info info;
  Renderer renderer;
  QUELL_INIT(info);
  memset(&renderer, 0, sizeof(renderer));
  if (quellChooseDevice(getenv("QUELL_TEST_DEVICE"), &info) != QUELL_SUCCESS) {
    fprintf(stderr, "%s\n", quellErrorMessage());
    return 1;
  }
  renderer.context = clCreateContext(NULL, 1, &info.device, NULL, NULL, NULL);
  renderer.queue = clCreateCommandQueue(renderer.context, info.device, 0, NULL);
  const int right = quellCreateDenoiser(renderer.context, info.device, renderer.queue, NULL, NULL,
                                        &renderer.denoiser) == QUELL_SUCCESS &&
                    run(&renderer);
  if (!right) fprintf(stderr, "failed: %s\n", quellErrorMessage());
  printf("%d frames from C, %d in flight, %.2f of radiance shown as %.4f: %s\n", kFrames, kInFlight,
         kRadiance, kEncoded, right ? "right" : "wrong");
  releaseSlots(&renderer);
  quellDestroyDenoiser(renderer.denoiser);
  clReleaseCommandQueue(renderer.queue);
  clReleaseContext(renderer.context);
  return right ? 0 : 1;
}
