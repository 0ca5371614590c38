/* The leak checker names a leak by its library only while that is loaded: in builds with it nothing is unloaded, so
   that scripts/lsan.supp can tell the OpenGL driver's leaks from ours. */
int dlclose(void* handle)
{
  (void)handle;
  return 0;
}
