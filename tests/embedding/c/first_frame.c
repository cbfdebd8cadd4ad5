/* The C example of docs/install.md: one frame of a renderer's own buffers, denoised on the renderer's own queue. C99. */
#include <quell/quell.h>
#include <stdio.h>
#include <stdlib.h>

enum { kWidth = 64, kHeight = 48, kChannels = 3, kComponents = kWidth * kHeight * kChannels };

/* [example] */
quell_status denoiseOneFrame(cl_context context, cl_device_id device, cl_command_queue queue, cl_mem radiance,
                             cl_mem normal, cl_mem position, cl_mem albedo, cl_mem display,
                             const quell_camera* camera) {
  quell_denoiser* denoiser = NULL;
  quell_status status = quellCreateDenoiser(context, device, queue, NULL, NULL, &denoiser);
  quell_frame frame;
  quell_output output;
  QUELL_INIT(frame);
  QUELL_INIT(output);
  frame.width = kWidth;
  frame.height = kHeight;
  frame.camera = *camera;
  frame.radiance =
      quellPackedImage(radiance, 3, QUELL_FLOAT32); /* packed float3; strides are in the struct */
  frame.normalWorld = quellPackedImage(normal, 3, QUELL_FLOAT32);
  frame.positionWorld = quellPackedImage(position, 3, QUELL_FLOAT32);
  frame.albedo = quellPackedImage(albedo, 3, QUELL_FLOAT32);
  output.display = quellPackedImage(display, 3, QUELL_FLOAT32);
  if (status == QUELL_SUCCESS)
    status = quellPrepare(denoiser, &frame, &output); /* once: builds and allocates */
  cl_event done = NULL;
  if (status == QUELL_SUCCESS)
    status = quellDenoise(denoiser, &frame, &output, 0, NULL, &done); /* every frame */
  if (status == QUELL_SUCCESS) {
    clWaitForEvents(1, &done);
    clReleaseEvent(done);
  } else {
    fprintf(stderr, "%s\n", quellErrorMessage());
  }
  quellDestroyDenoiser(denoiser);
  return status;
}
/* [example] */

static cl_mem makeImage(cl_context context, float value) {
  static float pixels[kComponents];
  for (int i = 0; i < kComponents; ++i) pixels[i] = value;
  return clCreateBuffer(context, CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, sizeof(pixels), pixels, NULL);
}

static int check(int holds, const char* what) {
  if (!holds) fprintf(stderr, "failed: %s\n", what);
  return holds ? 0 : 1;
}

int main(void) {
  quell_device_info info;
  QUELL_INIT(info);
  if (quellChooseDevice(getenv("QUELL_TEST_DEVICE"), &info) != QUELL_SUCCESS) {
    fprintf(stderr, "%s\n", quellErrorMessage());
    return 1;
  }
  cl_context context = clCreateContext(NULL, 1, &info.device, NULL, NULL, NULL);
  cl_command_queue queue = clCreateCommandQueue(context, info.device, 0, NULL);
  const quell_camera camera = {.worldToClip = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -1, 0}};
  cl_mem radiance = makeImage(context, 0.25f), normal = makeImage(context, 0.57735f);
  cl_mem position = makeImage(context, -2.0f), albedo = makeImage(context, 0.5f);
  cl_mem display = makeImage(context, 0.0f);

  int failures = check(denoiseOneFrame(context, info.device, queue, radiance, normal, position, albedo,
                                       display, &camera) == QUELL_SUCCESS,
                       "denoiseOneFrame");
  float pixel[kChannels] = {0.0f, 0.0f, 0.0f};
  clEnqueueReadBuffer(queue, display, CL_TRUE, 0, sizeof(pixel), pixel, 0, NULL, NULL);
  printf("%s, quell %s from C: %.4f %.4f %.4f\n", info.name, quellVersion(), pixel[0], pixel[1], pixel[2]);
  /* A constant image stays constant: 0.25^(1/2.2) = 0.5325. */
  failures += check(pixel[0] > 0.532f && pixel[0] < 0.533f, "a constant image stays constant");
  /* A radiance image of nothing is refused by name. */
  failures += check(denoiseOneFrame(context, info.device, queue, NULL, normal, position, albedo, display,
                                    &camera) == QUELL_INVALID_ARGUMENT,
                    "a NULL image is refused");
  failures += check(strstr(quellErrorMessage(), "radiance") != NULL, "the message names the image");

  cl_mem images[] = {radiance, normal, position, albedo, display};
  for (size_t i = 0; i < sizeof(images) / sizeof(images[0]); ++i) clReleaseMemObject(images[i]);
  clReleaseCommandQueue(queue);
  clReleaseContext(context);
  return failures;
}
